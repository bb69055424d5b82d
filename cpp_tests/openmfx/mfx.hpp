// The interface between a host and an effect of OpenMfx: version 1 of the mesh effect API and its suites. It is
// declared from the public documentation, independently of the library's declarations.
#pragma once

namespace mfx {

using Handle = void *;
using Status = int;

enum : Status {
    OK = 0,
    FAILED = 1,
    ERR_UNKNOWN = 3,
    ERR_MISSING_HOST_FEATURE = 4,
    ERR_UNSUPPORTED = 5,
    ERR_EXISTS = 6,
    ERR_MEMORY = 8,
    ERR_BAD_HANDLE = 9,
    ERR_BAD_INDEX = 10,
    ERR_VALUE = 11,
    REPLY_DEFAULT = 14
};

extern "C" {

struct OfxHost {
    Handle host;
    const void *(*fetchSuite)(Handle host, const char *name, int version);
};

struct OfxPlugin {
    const char *pluginApi;
    int apiVersion;
    const char *pluginIdentifier;
    unsigned int pluginVersionMajor;
    unsigned int pluginVersionMinor;
    void (*setHost)(OfxHost *host);
    Status (*mainEntry)(const char *action, const void *handle, Handle inArgs, Handle outArgs);
};

struct PropertySuiteV1 {
    Status (*propSetPointer)(Handle, const char *, int, void *);
    Status (*propSetString)(Handle, const char *, int, const char *);
    Status (*propSetDouble)(Handle, const char *, int, double);
    Status (*propSetInt)(Handle, const char *, int, int);
    Status (*propSetPointerN)(Handle, const char *, int, void *const *);
    Status (*propSetStringN)(Handle, const char *, int, const char *const *);
    Status (*propSetDoubleN)(Handle, const char *, int, const double *);
    Status (*propSetIntN)(Handle, const char *, int, const int *);
    Status (*propGetPointer)(Handle, const char *, int, void **);
    Status (*propGetString)(Handle, const char *, int, char **);
    Status (*propGetDouble)(Handle, const char *, int, double *);
    Status (*propGetInt)(Handle, const char *, int, int *);
    Status (*propGetPointerN)(Handle, const char *, int, void **);
    Status (*propGetStringN)(Handle, const char *, int, char **);
    Status (*propGetDoubleN)(Handle, const char *, int, double *);
    Status (*propGetIntN)(Handle, const char *, int, int *);
    Status (*propReset)(Handle, const char *);
    Status (*propGetDimension)(Handle, const char *, int *);
};

struct ParameterSuiteV1 {
    Status (*paramDefine)(Handle set, const char *type, const char *name, Handle *properties);
    Status (*paramGetHandle)(Handle set, const char *name, Handle *param, Handle *properties);
    Status (*paramSetGetPropertySet)(Handle set, Handle *properties);
    Status (*paramGetPropertySet)(Handle param, Handle *properties);
    Status (*paramGetValue)(Handle param, ...);
    Status (*paramGetValueAtTime)(Handle param, double time, ...);
    // Functions that effects do not call follow: derivatives, integrals, setting values, keys, copies, edits.
    void (*others[12])();
};

struct MeshEffectSuiteV1 {
    Status (*getPropertySet)(Handle effect, Handle *properties);
    Status (*getParamSet)(Handle effect, Handle *set);
    Status (*inputDefine)(Handle effect, const char *name, Handle *input, Handle *properties);
    Status (*inputGetHandle)(Handle effect, const char *name, Handle *input, Handle *properties);
    Status (*inputGetPropertySet)(Handle input, Handle *properties);
    Status (*inputRequestAttribute)(Handle input, const char *attachment, const char *name, int components,
                                    const char *type, const char *semantic, int mandatory);
    Status (*inputGetMesh)(Handle input, double time, Handle *mesh, Handle *properties);
    Status (*inputReleaseMesh)(Handle mesh);
    Status (*attributeDefine)(Handle mesh, const char *attachment, const char *name, int components, const char *type,
                              const char *semantic, Handle *attribute);
    Status (*meshGetAttributeByIndex)(Handle mesh, int index, Handle *attribute);
    Status (*meshGetAttribute)(Handle mesh, const char *attachment, const char *name, Handle *attribute);
    Status (*meshGetPropertySet)(Handle mesh, Handle *properties);
    Status (*meshAlloc)(Handle mesh);
    int (*abort)(Handle effect);
};

struct MessageSuiteV1 {
    Status (*message)(Handle effect, const char *type, const char *id, const char *format, ...);
};

} // extern "C"

} // namespace mfx
