"""gusset from the archive of `make dist`: conan create . --version VERSION [-o "gusset/*:shared=True"]

`make dist` copies this recipe to build/dist/conan with a conandata.yml that knows the archive. CMake finds gusset by the files that gusset
itself installs: find_package(gusset), then gusset::gusset.
"""

from pathlib import Path

from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.files import copy, get

required_conan_version = ">=2.0"


class GussetConan(ConanFile):
    name = "gusset"
    description = "Surfaces that come in pieces: stitching and mending of polygon meshes, nets of quads, smooth surfaces, outlines"
    license = "MIT OR Apache-2.0"
    topics = ("geometry", "mesh", "stitching", "hole-filling", "surface", "bezier")
    package_type = "library"
    settings = "os", "arch"
    options = {"shared": [True, False]}
    default_options = {"shared": True}

    def validate(self):
        sources = self.conan_data["sources"].get(self.version)
        if sources is None:
            raise ConanInvalidConfiguration(f"there is no archive of gusset {self.version}")
        if str(self.settings.arch) not in sources.get(str(self.settings.os), {}):
            raise ConanInvalidConfiguration(f"there is no archive of gusset for {self.settings.os} on {self.settings.arch}")

    def build(self):
        archive = self.conan_data["sources"][self.version][str(self.settings.os)][str(self.settings.arch)]
        get(self, **archive, strip_root=True)

    def package(self):
        root, package = self.build_folder, self.package_folder
        documents = str(Path(root) / "share/doc/gusset")
        for name in ("LICENSE-MIT", "LICENSE-APACHE", "copyright"):
            copy(self, name, documents, str(Path(package) / "licenses"))
        copy(self, "*", str(Path(root) / "include"), str(Path(package) / "include"))
        copy(self, "*", str(Path(root) / "lib/cmake"), str(Path(package) / "lib/cmake"))
        copy(self, "libgusset.so*" if self.options.shared else "libgusset.a", str(Path(root) / "lib"), str(Path(package) / "lib"))

    def package_info(self):
        self.cpp_info.libs = ["gusset"]
        # gusset's own files for CMake, in place of those that conan would make.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = ["lib/cmake/gusset"]
        self.cpp_info.set_property("pkg_config_name", "gusset")
        if not self.options.shared:
            # As in gussetTargets.cmake, for those who build by something else.
            self.cpp_info.system_libs = ["gcc_s", "util", "rt", "pthread", "m", "dl", "c"]
            flags = ["-Wl,--gc-sections", "-Wl,-z,nodelete", "-Wl,--exclude-libs,libgusset.a"]
            self.cpp_info.exelinkflags = flags
            self.cpp_info.sharedlinkflags = flags
