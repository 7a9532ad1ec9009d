// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>
#include <QStandardPaths>

#include "ui/app_setup.h"

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    // Tests are listed where there may be no display.
    if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
    QStandardPaths::setTestModeEnabled(true);
    ew::prepareApplication();
    QApplication application(argc, argv);
    ew::nameApplication();
    if (!ew::chooseLanguage("en")) return 2;
    return RUN_ALL_TESTS();
}
