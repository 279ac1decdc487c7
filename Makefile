# Each target sets up what it needs and can be run first; what is already there is not done again.
.PHONY: build demo test test-window farm bench sanitize unoptimised extension matrix lint fresh

build:
	tools/build.sh

demo:
	tools/demo.sh

test:
	tools/test.sh

test-window:
	tools/test_window.sh

farm:
	tools/farm.sh

bench:
	tools/bench.sh

sanitize:
	tools/sanitize.sh

unoptimised:
	tools/unoptimised.sh

extension:
	tools/extension.sh

matrix:
	tools/matrix.sh

lint:
	tools/lint.sh

fresh:
	tools/fresh.sh
