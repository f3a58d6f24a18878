# Builds, tests and measures Trocar on Debian 12. Each target first installs the Debian packages that are missing.
# Everything that is made goes into build/.

PRESET ?= release
PYTHON := /usr/bin/python3
# CGAL's headers take up to 2 GB to compile.
JOBS ?= $(shell awk -v cores=$$(nproc) '/^MemAvailable/ { n = int($$2 / 2000000) } \
    END { print n < 1 ? 1 : n < cores ? n : cores }' /proc/meminfo)

sources = find common strategies experiments results analysis tests -name node_modules -prune -o \
    \( -name '*.cpp' -o -name '*.h' \) -print0
scripts = find cmake analysis tests -name node_modules -prune -o -name '*.py' -print0

readme_table = results/reference/paper.md
readme_metrics = $(addprefix --metric=,tool_volume_inside_d_max depth_max_d_max facets_crossing_d_mean \
    self_crossings_h_mean displacement_mean_mean time_handle_p99)
# Which metrics tell the strategies apart when a tool goes into a closed organ slowly, and fast.
apart_table = results/reference/apart.md
apart = $(addprefix --only ,release=contact scene=penetration speed=20 speed=400 organ=sphere@4mm \
    organ=gallbladder@2mm organ=liver@4mm) --by speed,label \
    $(addprefix --metric=,vertices_inside_d_max depth_max_d_max facets_crossing_d_mean tool_points_inside_d_max \
    tool_volume_inside_d_max)
# What the readings of the paper's method leave: a table for each choice that its text leaves open, and one of all
# choices but how long a vertex is held. Those of the others are of vertices held while in contact.
readings_tables = release normals facets feedback all
readings_release = --by speed,release
readings_normals = --only release=contact --by speed,normals
readings_facets = --only release=contact --by speed,aggregate,order
readings_feedback = --only release=contact --by speed,feedback
readings_all = --only release=contact --only speed=20 --by aggregate,normals,order,feedback
readings_metrics = $(addprefix --metric=,tool_volume_inside_d_max depth_max_d_max facets_crossing_d_mean \
    self_crossings_h_mean spread_mean jitter_mean order_spread_mean_mean order_spread_max)
define make_readings_table
	build/trocar show build/readings/readings.h5 --markdown $(readings_$(1)) $(readings_metrics) \
	    > results/reference/readings_$(1).md
	$(PYTHON) cmake/readme_part.py strategies/readings.md $(1) results/reference/readings_$(1).md

endef
define check_readings_table
	$(PYTHON) cmake/readme_part.py strategies/readings.md $(1) results/reference/readings_$(1).md --check

endef

reference_bench = results/reference/benchmarks
reference_claims = results/reference/claims
define check_verdicts
	$(PYTHON) cmake/readme_part.py $(1) verdicts $(reference_claims)/verdicts.md --check

endef

# Which strategy when: the paper's comparison, scene by scene ranked, and going in what less penetration costs.
left_inside = --only release=contact --metric tool_volume_inside_d_max --markdown
define rank_strategies
	build/trocar rank build/paper/paper.h5 --only scene=$(1) $(left_inside) \
	    $(addprefix -o results/reference/choice/rank_$(1),.svg .png) > results/reference/choice/rank_$(1).md

endef
define draw_front
	build/trocar front build/paper/paper.h5 --only scene=penetration --only speed=$(1) $(left_inside) \
	    --against strain_mean $(addprefix -o results/reference/choice/front_$(1),.svg .png) \
	    > results/reference/choice/front_$(1).md

endef

# What the results are sensitive to: each sweep of experiments/sensitivity, and the condition that it varies.
sensitivity_sweeps = resolution speed rate tool stiffness wall
over_resolution = organ_facets
over_speed = speed
over_rate = rate
over_tool = tool
over_stiffness = rest_stiffness
over_wall = scene
# Through a thin wall the tool comes out at the other side.
figures_wall = $(addprefix --metric=,tool_volume_inside_d_max tunnelled_max facets_crossing_d_mean displacement_mean_mean)
# A case that fails (exit code 3) is in the result and on the picture.
define run_sensitivity
	build/trocar run experiments/sensitivity/$(1).toml -o build/sensitivity/$(1).h5 \
	    --metrics tool_volume_inside,tool_volume_at_rest,facets_crossing,displacement_mean,tunnelled || test $$? -eq 3
	build/trocar sensitivity build/sensitivity/$(1).h5 --over $(over_$(1)) $(figures_$(1)) --markdown \
	    $(addprefix -o results/reference/sensitivity/$(1),.svg .png) > results/reference/sensitivity/$(1).md

endef

# Figures 3 to 6 of the paper: from a sweep and the description of its panels to a picture.
define draw_paper_figure
	build/trocar run experiments/figures/$(1).toml --replay -o build/figures/$(1).h5
	build/trocar figure build/figures/$(1).h5 --panels analysis/figures/$(1).toml -o results/reference/figures/$(1).png
	build/trocar figure build/figures/$(1).h5 --panels analysis/figures/$(1).toml -o results/reference/figures/$(1).svg

endef

.NOTPARALLEL:
.PHONY: help packages lint_packages docs_packages configure build page paper pictures figures paper_figures claims sleep choice readings sensitivity everything test sanitize \
    test-full full_packages mutate lint docs bench reference_bench clean

help:  ## list the targets
	@sed -n 's/^\([a-z_-]*\):.*  ## /\1\t/p' Makefile | expand -t 16
	@echo "PRESET=debug (or asan, tsan) chooses another build than release; JOBS=1 uses one core."

build: configure page  ## build the program, build/trocar
	cmake --build --preset $(PRESET) --parallel $(JOBS)

# The report's page, analysis/page/dist: its libraries come from the npm registry as package-lock.json has them.
page = analysis/page
page: $(page)/dist/page.js  ## bundle the page of reports

$(page)/dist/page.js: $(page)/node_modules/.package-lock.json $(page)/build.mjs $(shell find $(page)/src -type f)
	cd $(page) && npm run build

$(page)/node_modules/.package-lock.json: $(page)/package.json $(page)/package-lock.json
	command -v npm > /dev/null || sh cmake/install_packages.sh packages-page.txt
	cd $(page) && npm ci
	touch $@

paper: build  ## run the paper's comparison: its table, its picture, its claims judged, and build/paper/report.html to look at it all
	mkdir -p build/paper
	build/trocar run experiments/paper.toml -o build/paper/paper.h5
	build/trocar show build/paper/paper.h5 --only release=contact --by scene,speed,label
	build/trocar run experiments/paper.toml $(addprefix --only ,organ=gallbladder@2mm scene=penetration speed=400 seed=1 \
	    release=contact) --replay -o build/paper/rapid.h5
	build/trocar snapshot build/paper/rapid.h5 -o build/paper/paper.png
	build/trocar reproduce --quick -o build/paper/claims.h5
	build/trocar merge build/paper/paper.h5 build/paper/rapid.h5 -o build/paper/report.h5
	cp build/paper/claims.turns.csv build/paper/report.turns.csv
	build/trocar report build/paper/report.h5 -o build/paper/report.html
	@echo "See it: open build/paper/report.html in a browser."

pictures: build  ## make the pictures on the metrics' pages anew
	build/trocar snapshot --metric all -o experiments/metrics/pages/pictures

# The picture of README.md shows the six that the paper has, drawn by the report's replay.
six = $(addprefix --only label=,fuzzy-per-vertex nearest-face cylinder-axis average-plane joint-vertex tool-facet)
figures: full_packages paper pictures  ## make the table and the picture of README.md anew, and those of the metrics' pages
	build/trocar show build/paper/paper.h5 $(addprefix --only ,release=contact scene=penetration) --markdown \
	    --by speed,label $(readme_metrics) > $(readme_table)
	build/trocar report build/paper/rapid.h5 -o build/paper/rapid.html
	node cmake/replay_picture.mjs build/paper/rapid.html results/reference/paper.png --width 1280 --height 780 \
	    --cases $$(build/trocar show build/paper/rapid.h5 --each $(six) | tail -n +2 | cut -d, -f1 | paste -sd,)
	build/trocar fuzzy plot -o build/paper/rules
	cp build/paper/rules/memberships.png build/paper/rules/response.png results/reference
	$(PYTHON) cmake/readme_part.py README.md table $(readme_table)
	build/trocar show build/paper/paper.h5 --markdown $(apart) > $(apart_table)
	$(PYTHON) cmake/readme_part.py experiments/metrics/README.md apart $(apart_table)

paper_figures: build  ## run the scenes of the paper's Figs. 3 to 6 and draw them, results/reference/figures/
	mkdir -p build/figures results/reference/figures
	$(foreach figure,fig3 fig4 fig5 fig6,$(call draw_paper_figure,$(figure)))

# Kept are the figures of cases and states that claims ask for: a hundredth of the whole.
reproduce = build/trocar reproduce -o build/claims/claims.h5 $(if $(MESHES),--confirmation $(MESHES))
claims: build  ## judge every claim of the paper on all seeds, results/reference/claims/; MESHES=folder runs the confirmation set too
	mkdir -p build/claims $(reference_claims)
	$(reproduce) --markdown > build/claims/claims.md
	$(reproduce) --json > $(reference_claims)/claims.json
	{ printf '# The claims of the paper, condition by condition\n\n'; cat build/claims/claims.md; } \
	    > $(reference_claims)/claims.md
	cp build/claims/claims.turns.csv $(reference_claims)
	sed '/^$$/q' build/claims/claims.md > $(reference_claims)/verdicts.md
	build/trocar merge build/claims/claims.h5 -o build/claims/tables.h5 --tables-only
	$(PYTHON) cmake/claims_columns.py build/claims/tables.h5 experiments/claims.toml
	h5repack build/claims/tables.h5 build/claims/small.h5
	xz -9e -c build/claims/small.h5 > $(reference_claims)/claims.h5.xz
	$(PYTHON) cmake/readme_part.py README.md verdicts $(reference_claims)/verdicts.md
	$(PYTHON) cmake/readme_part.py results/reference/README.md verdicts $(reference_claims)/verdicts.md

# The sweeps of the paper and of its claims as they are but for one line.
with_sleep = sed 's/^sleep = false/sleep = true/' $(1) > $(2)
sleep: build  ## what sleep changes in the paper's comparison and in the verdicts, results/reference/sleep/
	mkdir -p build/sleep/claims results/reference/sleep
	$(call with_sleep,experiments/paper.toml,build/sleep/paper.toml)
	cp experiments/claims.toml build/sleep
	set -e; for sweep in experiments/claims/*.toml; do \
	    $(call with_sleep,$$sweep,build/sleep/claims/$$(basename $$sweep)); done
	build/trocar run experiments/paper.toml -o build/sleep/full.h5
	build/trocar run build/sleep/paper.toml -o build/sleep/sleeping.h5
	$(PYTHON) cmake/sleep_differences.py build/sleep/full.h5 build/sleep/sleeping.h5 > results/reference/sleep/differences.md
	build/trocar reproduce --quick -o build/sleep/claims_full.h5 --markdown > build/sleep/full.md
	build/trocar reproduce --quick --claims-file build/sleep/claims.toml -o build/sleep/claims_sleeping.h5 --markdown \
	    > build/sleep/sleeping.md
	sed '/^$$/q' build/sleep/full.md > results/reference/sleep/verdicts_full.md
	sed '/^$$/q' build/sleep/sleeping.md > results/reference/sleep/verdicts_sleeping.md

choice: paper  ## rank the strategies scene by scene and draw what less penetration costs, results/reference/choice/
	mkdir -p results/reference/choice
	$(foreach scene,penetration sliding cutting,$(call rank_strategies,$(scene)))
	$(foreach speed,20 400,$(call draw_front,$(speed)))

readings: build  ## run every reading of the paper's method, and make the tables of strategies/readings.md anew
	mkdir -p build/readings
	build/trocar run experiments/readings.toml -o build/readings/readings.h5
	$(foreach table,$(readings_tables),$(call make_readings_table,$(table)))

sensitivity: build  ## run the sweeps of what the results are sensitive to, and draw them anew in results/reference/sensitivity/
	mkdir -p build/sensitivity results/reference/sensitivity
	$(foreach sweep,$(sensitivity_sweeps),$(call run_sensitivity,$(sweep)))

everything: build  ## run every organ, tool, scene, strategy and release: nothing may fail or fly apart
	mkdir -p build/everything
	build/trocar run experiments/everything.toml -o build/everything/everything.h5
	build/trocar show build/everything/everything.h5 --by scene,organ --metric wall_s

test: build  ## build and run the tests
	ctest --preset $(PRESET) --parallel $(JOBS) --no-tests=error

# Of the scripts for browsers, two are what the others share, and one measures.
page_tests = $(filter-out $(addprefix tests/page/,browser.mjs sample.mjs frame_time.mjs),$(wildcard tests/page/*.mjs))
# An X server starts anew when its last client leaves, and turns away who comes meanwhile: -noreset.
test_export = xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" $(PYTHON) -B tests/export/$(1)_test.py build/trocar build/export

test-full: full_packages test  ## the tests, and what they leave out: the page of reports in a browser, exports in VTK and ParaView
	cd $(page) && npm test
	set -e; for script in $(page_tests); do echo "$$script"; node "$$script"; done
	$(call test_export,vtk)
	$(call test_export,paraview)

races:  ## run eight threads at once through the fuzzy inference under ThreadSanitizer
	$(MAKE) configure PRESET=tsan TROCAR_LINK_PROGRAM=OFF
	cmake --build --preset tsan --target test_strategies --parallel $(JOBS)
	build/tsan/tests/strategies/test_strategies --gtest_filter='EightThreads.*'

chaos: build  ## kill a sweep and its workers 20 times, resume it, and compare it with an undisturbed run
	tests/chaos.sh build/$(PRESET)/experiments/trocar

sanitize:  ## run the tests under AddressSanitizer and UndefinedBehaviorSanitizer, but for those of Python alone
	$(MAKE) test PRESET=asan TROCAR_LINK_PROGRAM=OFF

mutate: packages  ## make deliberate errors in the metrics and see whether a test finds each; ALL=--all tries them all
	$(PYTHON) -B tests/mutations/mutate.py --jobs $(JOBS) $(ALL)

lint: lint_packages docs configure  ## check the format, the C++, the Python and the pages; a warning is an error
	$(sources) | xargs -0 clang-format --dry-run -Werror
	$(scripts) | xargs -0 -r $(PYTHON) -m pyflakes
	$(PYTHON) cmake/readme_part.py README.md table $(readme_table) --check
	$(PYTHON) cmake/readme_part.py experiments/metrics/README.md apart $(apart_table) --check
	$(foreach page,README.md results/reference/README.md,$(call check_verdicts,$(page)))
	$(foreach table,$(readings_tables),$(call check_readings_table,$(table)))
	$(PYTHON) cmake/readme_part.py tests/benchmarks/README.md tables $(reference_bench)/tables.md --check
	$(PYTHON) cmake/readme_part.py README.md consumer tests/package/consumer/consumer.cpp --check
	$(PYTHON) cmake/clang_tidy.py build/$(PRESET) --jobs $(JOBS)

docs: docs_packages  ## make the pages of every header and README.md, build/docs/html/index.html
	$(PYTHON) -B cmake/docs.py

bench: build  ## time the cycle and its phases; results in build/bench/*.json
	mkdir -p build/bench
	set -e; for program in build/$(PRESET)/tests/benchmarks/*_benchmark; do \
	    "$$program" --benchmark_out_format=json --benchmark_out=build/bench/$$(basename "$$program").json; \
	done
	$(PYTHON) cmake/benchmark_tables.py build/bench

reference_bench: bench  ## run the benchmarks and keep them as the reference, results/reference/benchmarks/
	mkdir -p $(reference_bench)
	cp build/bench/*_benchmark.json $(reference_bench)
	$(PYTHON) cmake/benchmark_tables.py $(reference_bench) > $(reference_bench)/tables.md
	$(PYTHON) cmake/readme_part.py tests/benchmarks/README.md tables $(reference_bench)/tables.md

clean:  ## remove build/
	rm -rf build

packages:
	@sh cmake/install_packages.sh packages.txt

full_packages:
	@sh cmake/install_packages.sh packages.txt packages-full.txt

docs_packages:
	@sh cmake/install_packages.sh packages-docs.txt

lint_packages:
	@sh cmake/install_packages.sh packages.txt packages-lint.txt

configure: packages
	cmake --preset $(PRESET) -DTROCAR_LINK_PROGRAM=$(or $(TROCAR_LINK_PROGRAM),ON)
