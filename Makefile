# Each target sets up what it needs and can be run first; what is already there is not done again.
.PHONY: build demo test test-window bench sanitize lint

build:
	tools/build.sh

demo:
	tools/demo.sh

test:
	tools/test.sh

test-window:
	tools/test_window.sh

bench:
	tools/bench.sh

sanitize:
	tools/sanitize.sh

lint:
	tools/lint.sh
