# Everything from nothing but python3, pip and a C++ compiler; uv is used if it is there.
#   make demo    simulate a testfield, calibrate it, print truth beside estimate and sigma, write the report
#   make test    the tests
#   make test-long  those of tests/slow.txt, and what needs a browser; PART=2/7 the second of seven parts
#   make test-versions  the tests with every Python from 3.11 that is here, and with the oldest dependencies allowed
#   make wheel   sdist and wheels as published, each installed into an empty environment and tried, for every Python here
#   make check   the whole gate: format, lint, types, layers, generated files, docs
#   make ledger  errors over stated standard deviations, set by set, and docs/ledger.md; LEDGER="--sets NAME,... --redo"
#   make bench   benchmarks (figures into benchmarks/results), long tests and those that take minutes
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
UV := $(shell command -v uv 2>/dev/null)
export RAYBUNDLE_REQUIRE_NATIVE ?= 1
SOURCES := $(wildcard cpp/*) CMakeLists.txt pyproject.toml

.PHONY: setup setup-dev demo test test-long test-versions wheel check format lint types layers generated docs bench ledger clean

setup: $(VENV)/.installed

$(BIN)/python:
ifneq ($(UV),)
	$(UV) venv --quiet --seed --python $(PYTHON) $(VENV)
else
	$(PYTHON) -m venv $(VENV)
endif
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --upgrade "pip>=25.1"

# The package itself, compiled, in editable form.
$(VENV)/.installed: $(SOURCES) | $(BIN)/python
ifneq ($(UV),)
	VIRTUAL_ENV=$(VENV) $(UV) pip install --quiet --editable .
else
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable .
endif
	touch $@

setup-dev: $(VENV)/.installed-dev

$(VENV)/.installed-dev: $(VENV)/.installed
ifneq ($(UV),)
	VIRTUAL_ENV=$(VENV) $(UV) pip install --quiet --group dev
else
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --group dev
endif
	touch $@

demo: setup
	$(BIN)/raybundle demo --set demo_data/portal --out demo

test: setup-dev
	$(BIN)/python -m pytest -n 2 --dist loadfile -m "not long and not bench"

test-long: setup-dev
	$(BIN)/python -m pytest -n 2 -m "long and not bench" $(if $(PART),--part $(PART))

test-versions: setup-dev
	$(BIN)/python tools/versions.py $(VERSIONS) -n 2

wheel: setup-dev
	$(BIN)/python tools/wheel.py $(WHEEL)

check: format lint types layers generated writing docs

format: setup-dev
	$(BIN)/ruff format --check .

lint: setup-dev
	$(BIN)/ruff check .

types: setup-dev
	$(BIN)/basedpyright --level error

layers: setup-dev
	$(BIN)/lint-imports

generated: setup-dev
	$(BIN)/python tools/generate_kernels.py --check
	$(BIN)/python tools/public_api.py --check
	$(BIN)/python tools/generate_stubs.py --check
	PYTHONPATH=benchmarks $(BIN)/python -m ledger --page --check

writing: setup-dev
	$(BIN)/python tools/check_writing.py
	$(BIN)/codespell README.md docs src

docs: setup-dev
	$(BIN)/python tools/generate_docs.py --check
	$(BIN)/mkdocs build --strict --quiet --site-dir build/site

bench: setup-dev
	$(BIN)/python -m pytest -n 2 -m "long or bench"
	$(BIN)/python benchmarks/run.py

ledger: setup-dev
	PYTHONPATH=benchmarks $(BIN)/python -m ledger $(LEDGER)

clean:
	rm -rf $(VENV) build demo site
