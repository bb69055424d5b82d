# gusset: the two commands are `make demo` and `make test`. Each says what it is about to install, and installs it as root or
# through sudo, or else prints the command and stops. `make help` lists the rest.

PREFIX  ?= /usr/local
DESTDIR ?=
CARGO   ?= cargo

version := $(shell sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)
abi     := $(basename $(version))
stage   := $(CURDIR)/build/stage
# A build of its own: the same file name would otherwise stand for two libraries.
openmfx := $(CURDIR)/target/openmfx/debug/libgusset.so
libdir  := $(DESTDIR)$(PREFIX)/lib
incdir  := $(DESTDIR)$(PREFIX)/include

build_packages := cmake g++ pkg-config
host_packages  := $(build_packages) libopenmesh-dev libcgal-dev libcli11-dev libfccp-dev
test_packages  := $(host_packages) doctest-dev libeigen3-dev valgrind
bench_packages := $(host_packages) fonts-dejavu-core glmark2-data libembree-dev libocct-modeling-algorithms-dev libocct-modeling-data-dev libsisl-dev nlohmann-json3-dev python3-venv
demo_packages  := $(host_packages) libcgal-demo f3d xvfb xauth

.PHONY: help build openmfx test check exhaustive demo bench install stage clean
.DEFAULT_GOAL := help

help:
	@echo 'make demo                         stitch two halves of a real mesh, with pictures, into build/demo'
	@echo 'make demo A=left.obj B=right.obj  the same with your own files'
	@echo 'make test                         all tests: Rust, lints, header drift, C and C++'
	@echo 'make check                        the quick part of them: Rust tests and lints'
	@echo 'make exhaustive                   long searches for wrong answers of carcasses, by brute force; minutes'
	@echo 'make bench                        times and quality beside the peers, into target/bench/report.json and docs/benchmarks.md'
	@echo 'make bench ONLY=join [SLOW=1]     the cases whose names contain that, into the report alone; SLOW=1: none skipped'
	@echo 'make build                        the libraries, in target/release'
	@echo 'make openmfx                      the library with the entry points of OpenMfx, unoptimised, for the tests of them'
	@echo 'make install [PREFIX=/usr/local] [DESTDIR=]   libraries, headers, pkg-config file, licences'
	@echo 'make clean                        remove build and target'

build:
	$(CARGO) build --release --locked

check:
	$(CARGO) fmt --check
	$(CARGO) clippy --locked --all-targets -- -D warnings
	$(CARGO) test --locked
	RUSTDOCFLAGS='-D warnings' $(CARGO) doc --locked --no-deps --features openmfx

# What is ignored in `make test` because it takes minutes.
exhaustive:
	$(CARGO) test --release --locked --test 'carcass_*' -- --ignored --nocapture exhaustive_

# The library with the entry points of OpenMfx, for the tests of them; for use: cargo build --release --features openmfx.
openmfx:
	$(CARGO) rustc --locked --lib --crate-type cdylib --features openmfx --target-dir target/openmfx

test: check stage openmfx
	@scripts/install-packages.sh $(test_packages)
	cmake -S cpp_tests -B build/cpp -DGUSSET_PREFIX=$(stage) -DGUSSET_OPENMFX=$(openmfx)
	env -u MAKELEVEL -u MAKEFLAGS cmake --build build/cpp --parallel 2
	ctest --test-dir build/cpp --output-on-failure --no-tests=error

demo: stage
	@scripts/demo.sh '$(stage)' '$(A)' '$(B)' $(demo_packages)

bench: stage
	@scripts/bench.sh '$(stage)' '$(ONLY)' '$(SLOW)' $(bench_packages)

install: build
	install -d $(libdir)/pkgconfig $(incdir)/gusset $(DESTDIR)$(PREFIX)/share/doc/gusset
	install -m 755 target/release/libgusset.so $(libdir)/libgusset.so.$(version)
	ln -sf libgusset.so.$(version) $(libdir)/libgusset.so.$(abi)
	ln -sf libgusset.so.$(abi) $(libdir)/libgusset.so
	install -m 644 target/release/libgusset.a $(libdir)/libgusset.a
	install -m 644 include/*.h include/*.hpp $(incdir)
	install -m 644 include/gusset/*.hpp $(incdir)/gusset
	sed 's|@PREFIX@|$(PREFIX)|; s|@VERSION@|$(version)|' packaging/gusset.pc.in > $(libdir)/pkgconfig/gusset.pc
	install -m 644 LICENSE-MIT LICENSE-APACHE $(DESTDIR)$(PREFIX)/share/doc/gusset

# An installation of its own for tests and demo.
stage:
	@$(MAKE) --no-print-directory -s install PREFIX='$(stage)' DESTDIR=

clean:
	rm -rf build target
