# Each target sets up what it needs and can be run first; what is already there is not done again.
# `make help` prints the lines that begin with ##.
.PHONY: help build demo test test-window test-windows test-jobs farm bench sanitize unoptimised extension \
	windows macos repository gallery matrix lint fresh docs coverage

## these lines
help:
	@tools/help.sh

## the module into .venv, the add-on into build/addons/illustrate
build:
	tools/build.sh

## scenes drawn in a real Blender, under out/demo
demo:
	tools/demo.sh

## every test: C++, Python, the packages in two Blenders
test:
	tools/test.sh

## the add-on in a real window, on a screen of its own
test-window:
	tools/test_window.sh

## the same, from the packages, in every Blender that has windows
test-windows:
	tools/matrix.sh --window

## what may befall jobs (undo, files, quitting), each 100 times: half an hour
test-jobs:
	ILLUSTRATE_REPEATS=100 tools/test_window.sh job_scenarios

## farm templates on a real Slurm, openjd-cli and Node; as root
farm:
	tools/farm.sh

## counts and times
bench:
	tools/bench.sh

## native tests and a fuzzer under sanitizers
sanitize:
	tools/sanitize.sh

## C++ tests without optimisation, with all asserts
unoptimised:
	tools/unoptimised.sh

## the packages and the wheels, in dist
extension:
	tools/extension.sh

## wheels and package for Windows, tested under wine
windows:
	tools/windows.sh

## wheels and package for macOS, checked as far as Linux can
macos:
	tools/macos.sh

## an extension repository that Blender installs and updates from
repository:
	tools/repository.sh

## the paper's figures and twelve of our own
gallery:
	tools/gallery.sh

## the packages in every Blender: an hour, 12 GB
matrix:
	tools/matrix.sh

## formats, types, common mistakes
lint:
	tools/lint.sh

## demo and test in bare root folders
fresh:
	tools/fresh.sh

## the documentation site, in out/docs
docs:
	tools/docs.sh

## lines that no test runs: C++, module and add-on, the worst files first
coverage:
	tools/coverage.sh
