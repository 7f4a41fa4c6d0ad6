# The sweeps of docs/numerics-peers.md, in every program that is installed. The table goes to $(BUILD)/peers.
EMBREE_MASK = $(BUILD)/peers/embree_mask

$(EMBREE_MASK): tests/numerics/peers/embree_mask.cpp
	$(call say,CXX,$@) $(CXX) -std=c++17 -O2 -Wall -Wextra -Wshadow $< -lembree3 -o $@

.PHONY: peers embree-mask
embree-mask:
	@if echo '#include <embree3/rtcore.h>' | $(CXX) -E -x c++ - >/dev/null 2>&1; then \
	    $(MAKE) --no-print-directory $(EMBREE_MASK); \
	else \
	    echo "peers: Embree is left out, its headers are not installed (Debian: libembree-dev)"; \
	fi

peers: all embree-mask
	$(PYTHON) tests/numerics/peers/peers.py --povc $(POVC) --embree $(EMBREE_MASK) --work $(BUILD)/peers \
	    --table $(BUILD)/peers/peers.md $(PEERS_FLAGS)
