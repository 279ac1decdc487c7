# Each target sets up what it needs and can be run first; what is already there is not done again.
.PHONY: build demo test bench lint

build:
	tools/build.sh

demo:
	tools/demo.sh

test:
	tools/test.sh

bench:
	tools/bench.sh

lint:
	tools/lint.sh
