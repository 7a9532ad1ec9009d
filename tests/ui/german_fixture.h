// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

#include "tests/ui/window_fixture.h"

namespace ew::test {

/// A window in German.
class German : public WindowTest {
  protected:
    void SetUp() override {
        ASSERT_TRUE(translator_.load(QLocale("de"), "edgewright", "_", ":/translations"));
        // On top of the English that main() chose; taken off again for the other tests.
        ASSERT_TRUE(QCoreApplication::installTranslator(&translator_));
        WindowTest::SetUp();
    }
    void TearDown() override {
        WindowTest::TearDown();
        QCoreApplication::removeTranslator(&translator_);
    }

    QTranslator translator_;
};

}  // namespace ew::test
