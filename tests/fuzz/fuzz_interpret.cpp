// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as strokes on an empty sheet: whatever is drawn, interpret() answers with a candidate
// or with a reason.
#include "tests/fuzz/fuzz_strokes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ew::InterpretOptions options;
    ew::fuzz::readHead(ew::fuzz::headOf(data, size), options);
    const auto strokes = ew::fuzz::strokesOf(data, size);
    ew::fuzz::checkReading(ew::interpret(strokes, ew::fuzz::shippedTemplates(), options), 0);
    return 0;
}
