// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/kinds/canopen/dictionary/dictionary_view.h"

namespace codewheel {

class CanopenAtWork;

// What the project wants the objects of each node to be, as a transfer would write them.
DictionaryView::WantedByNode objectsWantedOn(const CanopenAtWork &bus);

} // namespace codewheel
