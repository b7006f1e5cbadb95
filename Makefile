# SPDX-License-Identifier: LGPL-2.1-or-later
#
# The whole of the handling. Every target makes what it needs first, from the Debian packages on.

SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
.DEFAULT_GOAL := help
.NOTPARALLEL:
MAKEFLAGS += --no-print-directory

# FreeCAD's Python is the system's; another python3 may come first on the PATH. For a FreeCAD that brings its own:
# make build PYTHON=/path/to/its/python3
PYTHON := /usr/bin/python3
export PYTHONDONTWRITEBYTECODE := 1

FREECAD := $(PYTHON) tools/freecad_run.py
# `make gui` has settings of its own: the user's stay as they are.
GUI_HOME := $(CURDIR)/build/freecad-home
PYTEST := $(PYTHON) -m pytest
# Each process has a FreeCAD of its own.
PYTEST_SPREAD := $(PYTEST) --numprocesses $(shell nproc)
# Every test is a process of its own.
CTEST := ctest --output-on-failure --no-tests=error --parallel $(shell nproc)
# No GPU, no sound, no sandbox for FreeCAD's start page: what a bare machine or a container has.
DISPLAY_RUN := QTWEBENGINE_DISABLE_SANDBOX=1 xvfb-run --auto-servernum --server-args="-screen 0 1600x1000x24"

# CMake tells much when all is well.
configure_preset = mkdir -p build && log=build/configure-$(1).log && cmake --preset $(1)
or_show_log = > $$log 2>&1 || { cat $$log >&2; exit 1; }

##@ What to run
help: ## this list
	@awk 'BEGIN { FS = ":.*## " } /^##@/ { printf "\n%s\n", substr($$0, 5) } \
	    /^[a-z-]+:.*## / { printf "  make %-14s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

demo: build ## headless FreeCAD on the shipped examples; files and pictures in build/demo/
	$(FREECAD) examples/run_demo.py

gallery: build ## patterns, what a net can lie on, and a filmed session: docs/patterns.png, sources.png, session.gif
	@$(PYTHON) examples/gallery.py docs/patterns.png
	@$(FREECAD) examples/sources.py docs/sources.png
	@$(MAKE) --no-print-directory film

film: build
	@mkdir -p build/film/home
	@FREECAD_USER_HOME=$(CURDIR)/build/film/home $(FREECAD) tools/install.py --link
	@FREECAD_USER_HOME=$(CURDIR)/build/film/home FUNICULAR_FILM=build/film/frames $(DISPLAY_RUN) freecad examples/film.py \
	    > build/film/log 2>&1 || { cat build/film/log >&2; exit 1; }
	@$(PYTHON) examples/film.py build/film/frames docs/session.gif

guide: build ## the pictures of docs/guide.md, taken in FreeCAD's window on a virtual display
	@mkdir -p build/guide/home
	@FREECAD_USER_HOME=$(CURDIR)/build/guide/home $(FREECAD) tools/install.py --link
	@FREECAD_USER_HOME=$(CURDIR)/build/guide/home FUNICULAR_GUIDE=docs/guide LC_ALL=C.UTF-8 $(DISPLAY_RUN) \
	    freecad $(CURDIR)/examples/guide.py > build/guide/log 2>&1 || { cat build/guide/log >&2; exit 1; }

accuracy: build ## what accuracy costs in time, by each method: docs/accuracy.png; some minutes
	@$(PYTHON) examples/accuracy.py docs/accuracy.png

gui: build ## FreeCAD with the workbench loaded from this checkout
	@mkdir -p $(GUI_HOME)
	@FREECAD_USER_HOME=$(GUI_HOME) $(FREECAD) tools/install.py --link
	FREECAD_USER_HOME=$(GUI_HOME) freecad

install: build ## copy the workbench into FreeCAD's Mod folder of this user
	$(FREECAD) tools/install.py

##@ What to run while working on it
setup: ## install the Debian packages of tools/packages.txt that are missing (root or sudo)
	@tools/setup.sh

configure: setup
	@$(call configure_preset,release) -D PYTHON_EXECUTABLE=$(PYTHON) -D Python_EXECUTABLE=$(PYTHON) $(or_show_log)

build: configure ## compile the core into src/freecad_wb/funicular/
	@cmake --build build/release --target _core

lint: configure ## clang-format, clang-tidy, black, flake8: changes nothing
	@tools/lint.sh

format: setup ## let clang-format and black rewrite the sources
	@tools/format.sh

translations: build ## bring Resources/translations up to what a user can read; NEW=fr begins French
	@$(FREECAD) tools/translations.py $(NEW)

##@ Measuring
# BENCH_QUICK=1 stops at 10⁴ nodes and leaves out the relaxation: minutes instead of half an hour.
# BENCH_FILTER is a regular expression: 'cold/S/', 'factor', 'forces|tangent'; then nothing but the core is timed, and
# no page written. A solve that did not converge (core_bench ends with 1) is for the table to tell.
# BENCH_PAGE says where the page goes: else a full run's is docs/performance.md, a quick one's stays in build/bench/.
BENCH_QUICK :=
BENCH_FILTER := .
BENCH_PAGE :=
bench_extent = $(if $(BENCH_QUICK),quick,full)
bench: build ## time everything: tables, CSV files and plots in build/bench/, docs/performance.md (BENCH_QUICK=1)
	@cmake --build build/release --target core_bench
	@mkdir -p build/bench
	@$(FREECAD) bench/machine.py build/bench/machine.json build/release/bench/core_bench \
	    $(if $(filter .,$(BENCH_FILTER)),$(bench_extent),part)
	build/release/bench/core_bench --extent=$(bench_extent) --csv=build/bench/results.csv \
	    --benchmark_filter='$(BENCH_FILTER)' || test $$? -eq 1
	@$(PYTHON) bench/table.py build/bench/results.csv
	@$(PYTHON) bench/plot.py build/bench/results.csv build/bench/results.png
ifeq ($(BENCH_FILTER),.)
	$(PYTHON) bench/accuracy_curves.py build/bench/accuracy.csv $(bench_extent)
	$(PYTHON) bench/effect_costs.py build/bench/costs.csv $(bench_extent)
	$(FREECAD) bench/sampling.py build/bench/sampling.csv $(bench_extent)
	$(FREECAD) bench/documents.py build/bench/documents.csv $(bench_extent)
	@mkdir -p build/bench/home
	@FREECAD_USER_HOME=$(CURDIR)/build/bench/home $(FREECAD) tools/install.py --link
	@FREECAD_USER_HOME=$(CURDIR)/build/bench/home FUNICULAR_FRAMES=build/bench/frames.csv $(DISPLAY_RUN) freecad \
	    bench/frames.py > build/bench/frames.log 2>&1 || { cat build/bench/frames.log >&2; exit 1; }
	@grep "nodes, " build/bench/frames.log
	@$(PYTHON) bench/page.py build/bench $(BENCH_PAGE)
endif

bench-peers: build ## time other packages, from the Python package index, on the same net; adds them to the page
	@cmake --build build/release --target core_bench
	@mkdir -p build/bench
	@$(PYTHON) bench/machine.py build/bench/peers.json build/release/bench/core_bench $(bench_extent)
	@$(PYTHON) bench/peers/run.py $(bench_extent)
	@$(PYTHON) bench/page.py build/bench $(BENCH_PAGE)

##@ Tests
test: lint build test-core test-sanitize test-house test-python test-freecad test-gui ## all of it: lint, build and every test below
	@echo "make test: all passed"

test-core: configure ## the C++ core
	@cmake --build build/release
	$(CTEST) --test-dir build/release

test-sanitize: setup ## the C++ core under AddressSanitizer and UndefinedBehaviorSanitizer
	@$(call configure_preset,sanitize) $(or_show_log)
	@cmake --build build/sanitize
	$(CTEST) --test-dir build/sanitize

test-house: setup ## who may know whom, licences, the addon's description
	$(PYTEST) tests/house

test-python: build ## the numeric package, without FreeCAD
	$(PYTEST_SPREAD) tests/python

test-freecad: build ## the document objects, in headless FreeCAD
	$(PYTEST_SPREAD) tests/freecad

test-gui: build ## the workbench's windows, on a virtual display
	$(DISPLAY_RUN) $(PYTEST) tests/gui

# In seconds: `make soak SOAK_SECONDS=28800` for a night.
SOAK_SECONDS := 600

soak: build ## random scenes and mesh files for SOAK_SECONDS (600): new ones every time
	@$(call configure_preset,fuzz) $(or_show_log)
	@cmake --build build/fuzz --target fuzz_scene
	PYTHON=$(PYTHON) tests/fuzz/soak.sh $(SOAK_SECONDS)

clean: ## remove build/ and the compiled module
	rm -rf build src/freecad_wb/funicular/_core*.so

.PHONY: help demo gallery film guide accuracy gui install setup configure build lint format translations bench bench-peers test test-core test-sanitize test-house \
	test-python test-freecad test-gui soak clean
