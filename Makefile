# gusset: the two commands are `make demo` and `make test`. Each says what it is about to install, and installs it as root or
# through sudo, or else prints the command and stops. `make help` lists the rest.

PREFIX  ?= /usr/local
LIBDIR  ?= $(PREFIX)/lib
DOCDIR  ?= $(PREFIX)/share/doc/gusset
DESTDIR ?=
CARGO   ?= cargo
OBJCOPY ?= objcopy
# release, or release-debug: the same with line tables.
PROFILE ?= release
# The download address of the archive of `make dist`, for the recipes beside it.
DIST_URL ?= file://$(CURDIR)/build/dist

manifest = $(shell sed -n 's/^$(1) = "\(.*\)"/\1/p' Cargo.toml | head -n 1)
version := $(call manifest,version)
abi     := $(basename $(version))
release := $(or $(CARGO_TARGET_DIR),target)/$(PROFILE)
stage   := $(CURDIR)/build/stage
# Folder of the program. An installation includes the program if it was built; the stage does not.
program  = build/cli
cli      = $(shell test -x '$(program)/gusset' && echo yes)
archive := $(CURDIR)/build/dist/gusset-$(version)-linux-$(shell uname -m).tar.gz
openmfx := $(abspath $(release))/libgusset_openmfx.so
files   := $(abspath $(release))/libgusset_files.so
libdir   = $(DESTDIR)$(LIBDIR)
incdir   = $(DESTDIR)$(PREFIX)/include
docdir   = $(DESTDIR)$(DOCDIR)
# Licences of the linked libraries. Debian's tools install the file themselves.
notices  = packaging/debian/copyright

build_packages := cmake g++ pkg-config
host_packages  := $(build_packages) libopenmesh-dev libcgal-dev libcli11-dev libfccp-dev libtinyobjloader-dev
docs_packages  := doxygen
# A browser without a window: takes the pictures of the demo, and reads pages in tests.
browser_packages := chromium chromium-driver python3-selenium
test_packages  := $(host_packages) $(docs_packages) $(browser_packages) assimp-utils python3-pil fish groff-base zsh doctest-dev libeigen3-dev valgrind clang abigail-tools python3-venv
bench_packages := $(host_packages) fonts-dejavu-core glmark2-data libcgal-demo libeigen3-dev libassimp5 libembree-dev libocct-modeling-algorithms-dev libocct-modeling-data-dev libsisl-dev nlohmann-json3-dev python3-venv
cargo_c_packages := $(build_packages) libssl-dev
deb_packages   := debhelper dpkg-dev lintian $(build_packages)
demo_packages  := $(host_packages) libcgal-demo
pictures_packages := $(demo_packages) $(browser_packages) libegl1 nlohmann-json3-dev python3-venv
figures_packages := $(host_packages)

.PHONY: help build test-hosts-all wheel check-wheel wasm scans openmfx files test test-units test-programs test-hosts test-rust check mutants lint lint-prose lint-rust lint-hosts exhaustive torture complexity differential sanitize fuzz cli check-cancel demo docs pictures figures bench kinds install install-library install-program install-data install-debug dist check-dist check-conan check-deb check-abi abi-baseline check-cargo-c deb stage clean
.DEFAULT_GOAL := help

help:
	@echo 'make demo                         stitch two halves of a real mesh, with a page to turn it and pictures, into build/demo'
	@echo 'make demo A=left.obj B=right.obj  the same with your own files'
	@echo 'make test                         all tests: Rust, header drift, C and C++'
	@echo 'make test-hosts-all               those that need VTK, MPI, PyVista or Dask, half a gigabyte that `make test` does without'
	@echo 'make lint                         formatting, lints, both documentations, headers and examples by themselves; spelling and licences, if'
	@echo '                                  typos and cargo-deny are there'
	@echo 'make check                        both of Rust, without C and C++'
	@echo 'make exhaustive                   all cases of the tests that try many, and long searches by brute force; minutes'
	@echo 'make differential [CASES=1000] [FAMILY=loops] [SEED=1]  random campaigns against CGAL, OpenMesh and brute force, with a table; minutes'
	@echo 'make mutants FOLDER=crates/gusset-stitch/src/boundary [PROGRAM=mesh] [SHARD=0/20]  mistakes that no test notices, by cargo-mutants'
	@echo 'make complexity                   memory at n, 2 n and 4 n on the worst inputs that are known, larger ones than in make test; minutes'
	@echo 'make sanitize [KIND=thread] [TESTS=regex]  the C and C++ tests with the library under the address sanitizer, or that of threads; minutes'
	@echo 'make torture [TOGETHER=20000]     each function again and again with hostile arguments, so many at a time, with cancels, and without each allocation; minutes'
	@echo 'make fuzz [TARGET=sew] [SECONDS=60]  the fuzzers, each for so many seconds; what they find is left in build/fuzz'
	@echo 'make docs                         the site of the C and C++ interface, in build/docs/html'
	@echo 'make pictures                     draws the pictures of docs/ and the page of showcases anew'
	@echo 'make figures                      draws the figures of the papers anew, into docs/figures'
	@echo 'make bench                        times and quality beside the peers, into target/bench/report.json and docs/benchmarks.md'
	@echo 'make bench ONLY=join [SLOW=1]     the cases whose names contain that, into the report alone; SLOW=1: none skipped'
	@echo 'make kinds [ONLY=tubes] [SEED=1]  random cases of each kind of fault that people report, judged by trimesh and CGAL; minutes'
	@echo 'make cli                          the program gusset, its manual and its completions, into build/cli'
	@echo 'make scans FOLDER=views OUT=model.ply  overlapping scans of a folder, PLY files, made one closed mesh; pictures if PyVista is there'
	@echo 'make check-cancel [ONLY=weld]     how fast the filters stop on large meshes, on a machine that does nothing else; minutes'
	@echo 'make build                        the libraries, in target/release'
	@echo 'make wasm                         the npm package in wasm: the library as WebAssembly, with its tests under node; minutes'
	@echo 'make openmfx                      the library with the entry points of OpenMfx'
	@echo 'make install [PREFIX=/usr/local] [LIBDIR=] [DESTDIR=]   libraries, headers, pkg-config file, CMake package, docs'
	@echo 'make install-debug                the same with line tables and symbols, for debuggers and profilers'
	@echo 'make dist [DIST_URL=]             an archive for those without Rust, and recipes of conan and vcpkg for it, into build/dist'
	@echo 'make check-dist                   whether another checkout makes the same bytes of it; builds the library again'
	@echo 'make wheel                        the Python package, into target/wheels'
	@echo 'make check-wheel                  it, in a new environment without Rust'
	@echo 'make check-conan                  the recipe of conan by conan, which it installs from PyPI into build'
	@echo 'make check-abi                    whether the binary interface is that of packaging/abi; it is in make test too'
	@echo 'make abi-baseline [UNRELEASED=1]  writes it anew, where its rule allows; UNRELEASED=1: although programs would break'
	@echo 'make check-cargo-c                the installation that cargo-c makes, looked at like ours; builds cargo-c, minutes'
	@echo 'make deb                          Debian packages, into build/deb'
	@echo 'make check-deb                    the tests of those packages, which it installs and removes again; as root'
	@echo 'make clean                        remove build and target'

# Keeps folders of the build machine out of the binaries, unless RUSTFLAGS is set, which replaces these flags.
cargo_home := $(or $(CARGO_HOME),$(HOME)/.cargo)
remapped   := "--remap-path-prefix=$(cargo_home)=/cargo", "--remap-path-prefix=$(CURDIR)=/gusset-$(version)"
released   := --config 'build.rustflags=[$(remapped)]'

# Features of the library for C that the crate lacks, and none of the program, which loads that library.
features   := --no-default-features --features gusset/reserve

# Compiles the packages $(1), or with ALL=yes all that `make test` needs at once: cargo unites the features of the packages that
# it builds together, and compiles a dependency again for other features.
tested  := -p gusset -p gusset-cli -p gusset-files -p gusset-interface -p gusset-openmfx -p gusset-tests $(features),gusset-files/reserve
compile  = $(CARGO) build $(if $(ALL),$(tested),$(1)) --profile $(PROFILE) --locked $(released)

build:
	$(call compile,-p gusset $(features))

# All checks of a change, except the hosts' side.
check: lint-rust test-rust

test-rust: test-units test-programs

lint: lint-prose lint-rust lint-hosts

# Comments, pages and names follow the rules of CONTRIBUTING.md.
lint-prose:
	@scripts/lint-prose.sh

# Also checks the fuzzers, under a stable compiler and without linking; `make fuzz` runs them.
lint-rust:
	$(CARGO) fmt --all --check
	$(CARGO) clippy --locked --workspace --all-targets -- -D warnings
	RUSTDOCFLAGS='-D warnings' $(CARGO) doc --locked --workspace --exclude gusset-tests --exclude gusset-fuzz --exclude gusset-cli --no-deps
	@# After the library: both are called gusset, and write one folder.
	RUSTDOCFLAGS='-D warnings' $(CARGO) doc --locked -p gusset-cli --no-deps
	@if command -v typos > /dev/null; then typos; else echo 'Skipped, as it is not installed: typos (cargo install typos-cli)'; fi
	@if command -v cargo-deny > /dev/null; then $(CARGO) deny --workspace --locked --offline check bans licenses sources; \
	else echo 'Skipped, as it is not installed: cargo-deny (cargo install cargo-deny)'; fi

# Builds the site of the C and C++ interface without warnings or broken links, and compiles each header and example
# alone. Needs no library.
lint-hosts: docs
	@scripts/install-packages.sh $(test_packages)
	@$(MAKE) --no-print-directory -s install-data PREFIX='$(CURDIR)/build/lint' DESTDIR=
	scripts/lint-hosts.sh build/lint

# The description of the C interface, from which other files are generated. Its time changes only if it changes.
interface = $(if $(ALL),$(release)/gusset-interface,$(CARGO) run -q --locked -p gusset-interface --)
.PHONY: build/interface.json
build/interface.json: $(if $(ALL),build)
	@mkdir -p build
	@$(interface) describe $@

# The unit tests of the crates that no other one needs to be compiled for, in a plain build, with checks of overflow.
plain  = $(filter-out gusset-files gusset-openmfx,$(shell grep -rl '^ *\#\[test\]' crates | cut -d/ -f2 | sort -u))
units  = $(addprefix -p ,$(plain) gusset-oracles) --features gusset-base/reserve
test-units:
	CARGO_INCREMENTAL=0 $(CARGO) test --locked $(units) --lib

# Tests the released library from outside. Also runs the unit tests of the packages that link it, and the example of its first page.
test-programs: ALL = yes
test-programs: build
	$(CARGO) test --locked $(tested) --lib --bins --test '*' --release $(released) --no-fail-fast
	$(CARGO) test --locked -p gusset $(features) --doc --release $(released)

# Runs the tests that `make test` ignores because they take minutes, and all cases of sampled tests.
exhaustive:
	GUSSET_EXHAUSTIVE=1 $(CARGO) test --locked -p gusset-tests --release $(released) --test curve --test mesh --test net --test surface
	$(CARGO) test --locked $(units) --lib --release $(released)
	$(CARGO) test --locked -p gusset-tests --release $(released) --test surface -- --ignored --nocapture exhaustive_

# Plants mistakes one at a time in a folder of a crate, and runs its unit tests and a test program. build/mutants.out
# lists the mistakes that no test notices. SHARD=0/20 tries one of twenty.
mutated = $(notdir $(firstword $(subst /src, ,$(FOLDER))))
mutants:
	@test -n '$(FOLDER)' -a -d '$(FOLDER)' || { echo 'gusset: say which folder of a crate: make mutants FOLDER=crates/gusset-stitch/src/boundary'; exit 1; }
	@command -v cargo-mutants > /dev/null || { echo 'gusset: please run: cargo install --locked cargo-mutants'; exit 1; }
	GUSSET_DATA='$(or $(GUSSET_DATA),$(abspath ../shared/data))' $(CARGO) mutants --profile mutants --no-shuffle --timeout 300 --output build \
	    $(addprefix --shard ,$(SHARD)) --package '$(mutated)' --file '$(FOLDER)/**' --test-package '$(mutated)' --cargo-test-arg=--package=gusset-tests \
	    --cargo-test-arg=--lib --cargo-test-arg=--test --cargo-test-arg=$(or $(PROGRAM),mesh)

# The library with the entry points of OpenMfx.
openmfx:
	$(call compile,-p gusset-openmfx)

# Readers and writers of files, for tests of the Python package. `make wheel` links them into the library of the package.
files:
	$(call compile,-p gusset-files --features reserve)

# Runs both sides at once, because each keeps only one core busy at times.
test:
	@scripts/install-packages.sh $(test_packages)
	@$(MAKE) --no-print-directory ALL=yes build
	@$(MAKE) --no-print-directory ALL=yes --jobs=2 --output-sync=line test-hosts test-rust

# The tests have their own program and archive.
test_folder   := $(CURDIR)/build/test
test_program  := pack_level=1 program='$(test_folder)/cli' archive='$(test_folder)/dist/$(notdir $(archive))'
test-hosts: openmfx files build/interface.json
	@$(MAKE) --no-print-directory dist $(test_program)
	cmake -S cpp_tests -B build/cpp -DGUSSET_PREFIX=$(stage) -DGUSSET_OPENMFX='$(openmfx)' -DGUSSET_FILES='$(files)' -DGUSSET_ARCHIVE='$(test_folder)/dist/$(notdir $(archive))' -DGUSSET_CLI='$(test_folder)/cli'
	env -u MAKELEVEL -u MAKEFLAGS cmake --build build/cpp --parallel 2
	ctest --test-dir build/cpp --output-on-failure --no-tests=error --parallel 2 || \
	    { echo 'FAILED. The same tests once more, to see whether they fail again:'; ctest --test-dir build/cpp --rerun-failed --output-on-failure; exit 1; }

# Tests that need VTK, MPI, PyVista or Dask.
test-hosts-all: stage files build/interface.json
	@scripts/install-packages.sh $(test_packages) libopenmpi-dev libvtk9-dev openmpi-bin
	cmake -S cpp_tests -B build/cpp-all -DGUSSET_PREFIX='$(stage)' -DGUSSET_FILES='$(files)' -DGUSSET_ALL_HOSTS=ON
	env -u MAKELEVEL -u MAKEFLAGS cmake --build build/cpp-all --parallel 2 --target all_hosts
	ctest --test-dir build/cpp-all -R '^(vtk|tiles|python)' --output-on-failure --no-tests=error --parallel 2

# Compiles the program against the release library, which it loads. build/cli has it with its manual, its completions and a
# link to the library; `make install` installs it.
cli: stage
	$(call compile,-p gusset-cli $(features))
	@scripts/program.sh '$(release)/gusset' '$(stage)/lib' '$(program)'

scans: cli
	@python3 scripts/scans.py build/cli/gusset '$(FOLDER)' '$(or $(OUT),scans.ply)'

# Compares bytes with the native library.
wasm: stage build/interface.json
	@CARGO='$(CARGO)' scripts/wasm.sh '$(stage)'

torture: stage files build/interface.json
	@scripts/install-packages.sh $(test_packages)
	cmake -S cpp_tests -B build/cpp -DGUSSET_PREFIX=$(stage) -DGUSSET_FILES='$(files)'
	env -u MAKELEVEL -u MAKEFLAGS cmake --build build/cpp --target torture plugin_memory files_memory --parallel 2
	TORTURE_TOGETHER=$(or $(TOGETHER),20000) TORTURE_CANCELS=100000 TORTURE_ALLOCATIONS=1000000 ctest --test-dir build/cpp -R '^torture/|^(plugin|files)/memory$$' --verbose --parallel 2

# Runs CASES of each family, or of FAMILY. A failure prints the command that repeats it.
differential: stage build/interface.json
	@scripts/install-packages.sh $(test_packages)
	cmake -S cpp_tests -B build/cpp -DGUSSET_PREFIX=$(stage)
	env -u MAKELEVEL -u MAKEFLAGS cmake --build build/cpp --target campaign --parallel 2
	build/cpp/differential/campaign --cases $(or $(CASES),1000) --seed $(or $(SEED),1) $(addprefix --family ,$(FAMILY))

# Measures memory at n, 2 n and 4 n on the worst known inputs, larger than in `make test`, which also counts
# instructions.
complexity: stage build/interface.json
	@scripts/install-packages.sh $(test_packages)
	cmake -S cpp_tests -B build/cpp -DGUSSET_PREFIX=$(stage)
	env -u MAKELEVEL -u MAKEFLAGS cmake --build build/cpp --target complexity --parallel 2
	build/cpp/complexity/complexity --scale 16
	build/cpp/complexity/complexity --operations --scale 4

# Runs both kinds in turn, or KIND.
sanitize: build/interface.json
	@scripts/install-packages.sh $(test_packages)
	@for kind in $(or $(KIND),address thread); do scripts/sanitize.sh $$kind '$(TESTS)' || exit 1; done

# Needs no clang: the Rust compiler has the passes of libFuzzer.
fuzz:
	@scripts/install-packages.sh g++
	@CARGO='$(CARGO)' scripts/fuzz.sh '$(or $(SECONDS),60)' '$(TARGET)'

check-cancel: stage build/interface.json
	@scripts/install-packages.sh $(test_packages)
	cmake -S cpp_tests -B build/cpp -DGUSSET_PREFIX=$(stage)
	env -u MAKELEVEL -u MAKEFLAGS cmake --build build/cpp --target plugin_cancel complexity_silence
	build/cpp/complexity/complexity_silence $(and $(ONLY),--only '$(firstword $(ONLY))'); functions=$$?; \
	build/cpp/plugin/plugin_cancel $(stage)/lib/libgusset.so $(ONLY) && exit $$functions

demo:
	@scripts/demo.sh '$(stage)' '$(A)' '$(B)' $(demo_packages) -- $(browser_packages)

docs: build/interface.json
	@scripts/install-packages.sh $(docs_packages)
	$(interface) reference build/reference
	@scripts/docs.sh

pictures: stage
	@scripts/pictures.sh '$(stage)' $(pictures_packages)

figures: stage
	@scripts/figures.sh '$(stage)' $(figures_packages)

bench: stage files
	@scripts/bench.sh '$(stage)' '$(ONLY)' '$(SLOW)' '$(files)' $(bench_packages)

# Random cases of each kind of fault that people report, and the small cases of ../shared/data. Needs cffi, numpy, scipy, trimesh in PYTHON; intersections
# are judged if there are a C++ compiler and CGAL.
PYTHON ?= python3
kinds: build files
	@cd python && $(PYTHON) build_backend.py ../$(release)/libgusset.so ../build/kinds/gusset_mesh ../$(release)/libgusset_files.so
	@cp python/gusset_mesh/*.py python/gusset_mesh/py.typed build/kinds/gusset_mesh
	PYTHONPATH=build/kinds $(PYTHON) bench/reported.py '$(or $(GUSSET_DATA),$(abspath ../shared/data))/cases'
	PYTHONPATH=build/kinds $(PYTHON) bench/kinds.py --only '$(ONLY)' --seed '$(or $(SEED),0)'

# Strips debug data of both. The static library also loses the Rust compiler's bitcode, half of its size, which C
# linkers ignore and nm misreads beside clang.
strip_shared = --strip-unneeded
strip_static = --strip-debug
install: install-library install-data
	@$(if $(cli),$(MAKE) --no-print-directory -s install-program)

install-program:
	install -D -m 755 '$(program)/gusset' $(DESTDIR)$(PREFIX)/bin/gusset
	install -D -m 644 '$(program)/gusset.1' $(DESTDIR)$(PREFIX)/share/man/man1/gusset.1
	install -D -m 644 '$(program)/gusset.bash' $(DESTDIR)$(PREFIX)/share/bash-completion/completions/gusset
	install -D -m 644 '$(program)/_gusset' $(DESTDIR)$(PREFIX)/share/zsh/vendor-completions/_gusset
	install -D -m 644 '$(program)/gusset.fish' $(DESTDIR)$(PREFIX)/share/fish/vendor_completions.d/gusset.fish

install-library: build
	install -d $(libdir)
	$(OBJCOPY) $(strip_shared) $(release)/libgusset.so $(libdir)/libgusset.so.$(version)
	chmod 755 $(libdir)/libgusset.so.$(version)
	ln -sf libgusset.so.$(version) $(libdir)/libgusset.so.$(abi)
	ln -sf libgusset.so.$(abi) $(libdir)/libgusset.so
	$(OBJCOPY) -D $(strip_static) -R .llvmbc -R .llvmcmd $(release)/libgusset.a $(libdir)/libgusset.a
	chmod 644 $(libdir)/libgusset.a

# Installs the files that need no build and suffice to compile against. Unchanged headers keep their time, so that
# their users are not compiled again.
install-data:
	install -d $(libdir)/pkgconfig $(libdir)/cmake/gusset $(incdir)/gusset $(DESTDIR)$(PREFIX)/share/gusset $(docdir)
	install -C -m 644 include/*.h include/*.hpp $(incdir)
	install -C -m 644 include/gusset/*.h include/gusset/*.hpp $(incdir)/gusset
	install -C -m 644 include/cmake/*.cmake $(libdir)/cmake/gusset
	install -C -m 644 include/gusset.symbols $(DESTDIR)$(PREFIX)/share/gusset
	install -C -m 755 tools/verify/verify.py $(DESTDIR)$(PREFIX)/share/gusset
	sed -e 's|@UP@|$(shell realpath -ms --relative-to='$(LIBDIR)/pkgconfig' '$(PREFIX)')|' \
	    -e 's|@LIB@|$(shell realpath -ms --relative-to='$(PREFIX)' '$(LIBDIR)')|' -e 's|@VERSION@|$(version)|' \
	    -e 's|@DESCRIPTION@|$(call manifest,description)|' packaging/gusset.pc.in > $(libdir)/pkgconfig/gusset.pc
	install -m 644 README.md CHANGELOG.md LICENSE-MIT LICENSE-APACHE $(wildcard $(notices)) $(docdir)
	find docs -name '*.md' -o -name '*.svg' -o -name '*.jpg' -o -name '*.html' | xargs -I% install -D -m 644 % $(docdir)/%
	printf '%s\n' ARCHITECTURE.md CONTRIBUTING.md examples/guides/* examples/rust/* examples/meshlab/LICENCE-NOTE.md examples/meshlab/try.py include/gusset.openmfx.symbols | \
	    xargs -I@ install -D -m 644 @ $(docdir)/@

install-debug:
	@$(MAKE) --no-print-directory install PROFILE=release-debug strip_shared= strip_static=

# For machines without Rust: docs/guides/linking.md.
pack_level = 9
dist: cli
	@scripts/dist.sh '$(archive)' '$(DIST_URL)' '$(program)' '$(pack_level)'

# Compiled separately: cargo treats a shared library alone as another target.
wheel:
	@scripts/install-packages.sh python3-venv
	@scripts/wheel.sh $(released)

check-wheel: wheel
	@scripts/check-wheel.sh

check-dist: dist
	@scripts/check-dist.sh '$(archive)'

check-conan: dist
	@scripts/check-conan.sh build/dist/conan

# Compares the binary interface with packaging/abi, whose script states the rule; `make test` does this, too.
check-abi abi-baseline:
	@scripts/install-packages.sh abigail-tools
	$(CARGO) test --locked -p gusset-tests --release $(released) --test interface
	@UNRELEASED='$(UNRELEASED)' packaging/abi/abi.sh $(patsubst check-abi,check,$(@:abi-%=%)) include

check-cargo-c:
	@scripts/check-cargo-c.sh $(cargo_c_packages)

deb:
	@scripts/deb.sh $(deb_packages)

check-deb:
	@scripts/check-deb.sh autopkgtest

# A separate installation for tests and demo. Unchanged files keep their time; files no longer installed are removed.
stage:
	@rm -rf '$(stage).new'
	@$(MAKE) --no-print-directory -s install PREFIX='$(stage).new' DESTDIR= cli=
	@scripts/renew.sh '$(stage).new' '$(stage)'

clean:
	rm -rf build target
