// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// What a label reads: without the mark of its key. "&Save" is "Save", "Doors && gates" is "Doors & gates".
QString plainLabel(QString label);

// A text as a label of a control that takes "&" for the mark of a key: "Doors & gates" is "Doors && gates".
QString asLabel(QString text);

} // namespace codewheel
