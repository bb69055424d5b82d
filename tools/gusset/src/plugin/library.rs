//! A loaded plugin.

use super::certificates::CertificateFunctions;
use super::filter::Filter;
use super::table_text;
use crate::failure::{Exit, Failure};
use gusset::capi::plugin::channels::gusset_plugin_attributes;
use gusset::capi::plugin::descriptor::{GUSSET_PLUGIN_ABI, gusset_plugin, gusset_plugin_values};
use std::ffi::{CStr, CString, OsStr, OsString};
use std::mem::offset_of;
use std::path::PathBuf;

/// A plugin. It stays loaded until the program ends.
#[derive(Clone, Copy)]
pub(crate) struct Plugin {
    tables: &'static gusset_plugin,
    /// Absent in libraries of others.
    certificates: Option<CertificateFunctions>,
}

// SAFETY: the tables never change, and their functions may be called from any thread.
unsafe impl Send for Plugin {}
// SAFETY: as above.
unsafe impl Sync for Plugin {}

type EntryFunction = unsafe extern "C" fn(host_abi: u32) -> *const gusset_plugin;

impl Plugin {
    /// Loads a plugin by path or name, or the library of this program.
    pub(crate) fn load(name: Option<&OsStr>) -> Result<Self, Failure> {
        match name {
            Some(name) => Self::open(&[name.to_owned()]),
            None if cfg!(feature = "linked") => Ok(Self::linked()),
            None => Self::open(&library_candidates()),
        }
    }

    #[cfg(feature = "linked")]
    fn linked() -> Self {
        // SAFETY: the entry function returns the tables of this version of the library, which live until the program ends.
        let tables = unsafe { gusset::capi::plugin::gusset_plugin_entry(GUSSET_PLUGIN_ABI).as_ref() };
        let tables = tables.expect("the linked library serves its own version");
        Self { tables, certificates: Some(CertificateFunctions::linked()) }
    }

    #[cfg(not(feature = "linked"))]
    fn linked() -> Self {
        unreachable!("only called with the feature `linked`")
    }

    fn open(names: &[OsString]) -> Result<Self, Failure> {
        let mut first_error = None;
        for name in names {
            // SAFETY: loading runs the initialisers of a library that the user chose.
            match unsafe { libloading::Library::new(name) } {
                Ok(library) => return Self::from_library(library, name),
                Err(error) => drop(first_error.get_or_insert_with(|| format!("{}: {error}", name.to_string_lossy()))),
            }
        }
        Err(Failure::new(Exit::Plugin, first_error.unwrap_or_else(|| "no library to load".into())))
    }

    fn from_library(library: libloading::Library, name: &OsStr) -> Result<Self, Failure> {
        let name = name.to_string_lossy();
        // SAFETY: a library with this symbol promises this type, as the plugin interface says.
        let entry = unsafe { library.get::<EntryFunction>(b"gusset_plugin_entry\0") }
            .map_err(|_| Failure::new(Exit::Plugin, format!("{name} is not a plugin: it lacks gusset_plugin_entry")))?;
        // SAFETY: the entry function takes any number, and its tables live as long as the library.
        let tables = unsafe { entry(GUSSET_PLUGIN_ABI).as_ref() };
        let tables = tables
            .filter(|tables| tables.abi == GUSSET_PLUGIN_ABI && tables.struct_size >= size_of::<gusset_plugin>())
            .ok_or_else(|| {
                Failure::new(
                    Exit::Plugin,
                    format!(
                        "{name} does not serve hosts of ABI {GUSSET_PLUGIN_ABI}; install the library of this program"
                    ),
                )
            })?;
        let certificates = CertificateFunctions::find(&library);
        // The tables are used until the program ends.
        std::mem::forget(library);
        Ok(Self { tables, certificates })
    }

    /// Returns the plugin's name and version.
    pub(crate) fn title(self) -> String {
        // SAFETY: texts of the tables.
        unsafe { format!("{} {}", table_text(self.tables.name), table_text(self.tables.version)) }
    }

    /// Returns all filters in menu order.
    pub(crate) fn filters(self) -> Vec<Filter> {
        // SAFETY: the table's function takes these indices.
        (0..self.tables.filter_count)
            .filter_map(|index| unsafe { (self.tables.filter)(index).as_ref() })
            .map(|raw| Filter::new(self, raw))
            .collect()
    }

    /// Returns a filter by its id or its name for scripts.
    pub(crate) fn find(self, name: &str) -> Option<Filter> {
        let id = CString::new(name).ok()?;
        // SAFETY: the id is a C string.
        let found = unsafe { (self.tables.find)(id.as_ptr()).as_ref() };
        found
            .map(|raw| Filter::new(self, raw))
            .or_else(|| self.filters().into_iter().find(|filter| filter.script_name() == name))
    }

    pub(super) fn certificate_functions(self) -> Option<CertificateFunctions> {
        self.certificates
    }

    pub(super) fn tables(self) -> &'static gusset_plugin {
        self.tables
    }

    /// Returns the functions for numbers of texts. If `struct_size` ends before `kind`, the plugin lacks this function.
    pub(super) fn values(self) -> Option<&'static gusset_plugin_values> {
        // SAFETY: the extension of this name has this type, and lives as long as the plugin.
        let found = unsafe { self.extension(c"values/1").cast::<gusset_plugin_values>().as_ref() };
        found.filter(|values| values.struct_size >= offset_of!(gusset_plugin_values, kind))
    }

    pub(super) fn attributes(self) -> Option<&'static gusset_plugin_attributes> {
        // SAFETY: the extension of this name has this type, and lives as long as the plugin.
        let found = unsafe { self.extension(c"attributes/1").cast::<gusset_plugin_attributes>().as_ref() };
        found.filter(|attributes| attributes.struct_size >= size_of::<gusset_plugin_attributes>())
    }

    /// Returns whether the plugin carries attributes from inputs to outputs.
    pub(crate) fn carries_attributes(self) -> bool {
        self.attributes().is_some()
    }

    unsafe fn extension(self, name: &CStr) -> *const std::ffi::c_void {
        // SAFETY: the name is a C string.
        unsafe { (self.tables.extension)(name.as_ptr()) }
    }
}

/// Paths of the library: beside the program, in `lib` beside the program's folder, and where the system looks.
fn library_candidates() -> Vec<OsString> {
    let name = library_name();
    let folder =
        std::env::current_exe().ok().and_then(|program| Some(program.canonicalize().ok()?.parent()?.to_path_buf()));
    let unversioned = format!("{}gusset{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
    let beside = folder
        .iter()
        .flat_map(|folder| [folder.join(&name), folder.join(&unversioned), folder.join("../lib").join(&name)]);
    let mut candidates: Vec<OsString> = beside.filter(|path| path.exists()).map(PathBuf::into_os_string).collect();
    candidates.push(name.into());
    candidates
}

fn library_name() -> String {
    let version = concat!(env!("CARGO_PKG_VERSION_MAJOR"), ".", env!("CARGO_PKG_VERSION_MINOR"));
    if cfg!(windows) {
        "gusset.dll".into()
    } else if cfg!(target_os = "macos") {
        format!("libgusset.{version}.dylib")
    } else {
        format!("libgusset.so.{version}")
    }
}
