// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/cams/cam_sheet.h"

#include <gtest/gtest.h>

namespace codewheel::test {

// The example of FRABA manual 5.4.4: cam 3 from 15h to 213h in program 1.
inline constexpr std::size_t manualCam = 3;
inline constexpr Cam manualValue{0x15, 0x213, true};

// A sheet of 1000 positions with the cam of the manual.
class CamSheetTest : public testing::Test
{
protected:
    CamSheetTest()
    {
        sheet.setLargest(999);
        sheet.setCam(manualCam, manualValue, {});
        sheet.document().undoStack().clear();
    }

    void undo() { sheet.document().undoStack().undo(); }
    void redo() { sheet.document().undoStack().redo(); }
    int steps() const { return sheet.document().undoStack().index(); }

    ProjectDocument project;
    CamSheet sheet{project};
};

} // namespace codewheel::test
