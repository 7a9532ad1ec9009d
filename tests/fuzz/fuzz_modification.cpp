// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as strokes on a solid that is there already, seen from anywhere: a change that leaves a
// solid, a new body, or a reason.
#include "tests/fuzz/fuzz_scenes.h"
#include "tests/fuzz/fuzz_strokes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const ew::fuzz::Scenes& scenes = ew::fuzz::scenes();
    const ew::fuzz::Head head = ew::fuzz::headOf(data, size);
    ew::InterpretOptions options;
    ew::fuzz::readHead(head, options);
    options.bodies = scenes.bodies[head.scene % scenes.bodies.size()];
    options.camera = scenes.views[head.view % scenes.views.size()];
    const auto strokes = ew::fuzz::strokesOf(data, size);
    ew::fuzz::checkReading(ew::interpret(strokes, ew::fuzz::shippedTemplates(), options),
                           options.bodies.size());
    return 0;
}
