// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/plain/plain_refusals.h"

#include "vocabulary/enumeration_rows.h"
#include "vocabulary/texts_of_kinds.h"

#include <QtGlobal>

#include <array>

namespace codewheel::test {
namespace {

constexpr std::array plainRefusalRows{
    SentenceRow{
        PlainRefusalId::noSuchKey, "plainNoSuchKey",
        QT_TRANSLATE_NOOP("Refusal", "The node does not have the key of %1. Check which node it is.")},
};
static_assert(areInOrder(plainRefusalRows, &SentenceRow::id, PlainRefusalId::noSuchKey));

} // namespace

constinit const RefusalFamily plainRefusals{plainRefusalRows};

namespace {

// Before anybody reads a journal.
const bool plainRefusalsAreAdded = [] {
    addRefusals(plainRefusals);
    return true;
}();

} // namespace
} // namespace codewheel::test
