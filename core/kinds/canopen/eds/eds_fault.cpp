// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/eds_fault.h"

#include "vocabulary/enumeration_rows.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel::canopen {
namespace {

constexpr std::size_t mostNotes = 1'000;

constexpr auto edsFaultRows = std::to_array<TextOf<EdsFault>>({
    {EdsFault::notUtf8,
     QT_TRANSLATE_NOOP("Eds", "The text is not UTF-8, and is read as Latin-1: names may be wrong.")},
    {EdsFault::lettersLost,
     QT_TRANSLATE_NOOP("Eds", "Letters were lost before (U+FFFD): names may be wrong.")},
    {EdsFault::noEqualSign,
     QT_TRANSLATE_NOOP("Eds", "This is neither a section nor KEY=VALUE: the line is skipped.")},
    {EdsFault::beforeSections,
     QT_TRANSLATE_NOOP("Eds", "This is before the first section: the line is skipped.")},
    {EdsFault::bracketOpen,
     QT_TRANSLATE_NOOP("Eds", "The bracket is not closed: the line is read as a section.")},
    {EdsFault::behindBracket,
     QT_TRANSLATE_NOOP("Eds", "What is behind the section in this line is skipped.")},
    {EdsFault::unknownKey, QT_TRANSLATE_NOOP("Eds", "This key is not known: it is skipped.")},
    {EdsFault::unknownSection, QT_TRANSLATE_NOOP("Eds", "This section is not known: it is skipped.")},
    {EdsFault::ofModule, QT_TRANSLATE_NOOP("Eds", "This is for modules of the device: it is skipped.")},
    {EdsFault::keyTwice, QT_TRANSLATE_NOOP("Eds", "This key is here twice: the first one counts.")},
    {EdsFault::sectionTwice, QT_TRANSLATE_NOOP("Eds", "This section is here twice: the first one counts.")},
    {EdsFault::commentBehind, QT_TRANSLATE_NOOP("Eds", "What is behind the value is a comment.")},
    {EdsFault::leadingZero, QT_TRANSLATE_NOOP("Eds", "The leading zero does not mean octal: read as %1.")},
    {EdsFault::fraction, QT_TRANSLATE_NOOP("Eds", "This is an integer: read as %1.")},
    {EdsFault::suffix,
     QT_TRANSLATE_NOOP("Eds", "The letters behind the number mean nothing here: read as %1.")},
    {EdsFault::notANumber, QT_TRANSLATE_NOOP("Eds", "\"%1\" is no number: it counts as not stated.")},
    {EdsFault::doesNotFit,
     QT_TRANSLATE_NOOP("Eds", "\"%1\" does not fit into the type %2: it counts as not stated.")},
    {EdsFault::unknownType,
     QT_TRANSLATE_NOOP("Eds", "\"%1\" is no data type of CiA 301: the device tells how long the object is.")},
    {EdsFault::unknownObjectType,
     QT_TRANSLATE_NOOP("Eds",
                       "\"%1\" is no object type of CiA 301: what has no subindexes counts as a variable.")},
    {EdsFault::unknownAccess,
     QT_TRANSLATE_NOOP(
         "Eds", "\"%1\" is no access: ro, wo, rw, rwr, rww or const is expected. It counts as not stated.")},
    {EdsFault::unknownMapping,
     QT_TRANSLATE_NOOP(
         "Eds", "\"%1\" does not say whether the object can be mapped: 0 or 1 is expected. It counts as 0.")},
    {EdsFault::lowOverHigh,
     QT_TRANSLATE_NOOP("Eds", "The low limit is above the high limit: both count as not stated.")},
    {EdsFault::nodeMissing,
     QT_TRANSLATE_NOOP("Eds", "\"%1\" lacks the number of the node ($NODEID): it is never written.")},
    {EdsFault::wrongCount,
     QT_TRANSLATE_NOOP("Eds", "The list announces %1 and has %2: it is read to its end.")},
    {EdsFault::noLists,
     QT_TRANSLATE_NOOP("Eds", "There are no lists of objects: the sections decide what there is.")},
    {EdsFault::noSection, QT_TRANSLATE_NOOP("Eds", "%1 is in the list and has no section: it is left out.")},
    {EdsFault::inNoList, QT_TRANSLATE_NOOP("Eds", "%1 has a section and is in no list: it is there.")},
    {EdsFault::inWrongList,
     QT_TRANSLATE_NOOP("Eds", "%1 is in the wrong list: its index decides whose object it is.")},
    {EdsFault::notInList, QT_TRANSLATE_NOOP("Eds", "\"%1\" is no index of an object: it is left out.")},
    {EdsFault::subsDiffer,
     QT_TRANSLATE_NOOP("Eds", "%1 subindexes are announced, and %2 are there: these count.")},
    {EdsFault::subAlone,
     QT_TRANSLATE_NOOP("Eds", "%1 has a subindex and no section of its own: the subindex is there.")},
    {EdsFault::noSubs, QT_TRANSLATE_NOOP("Eds", "%1 is to have subindexes and has none: it is left out.")},
    {EdsFault::tooManySubs, QT_TRANSLATE_NOOP("Eds", "%1 subindexes are more than there can be: it has %2.")},
    {EdsFault::otherCommissioning,
     QT_TRANSLATE_NOOP("Eds", "Node and rate are here twice, and differ: the first ones count.")},
    {EdsFault::badNode, QT_TRANSLATE_NOOP("Eds", "\"%1\" is no number of a node. Numbers go from 1 to 127; "
                                                 "leave the value out where it is not set.")},
    {EdsFault::badRate,
     QT_TRANSLATE_NOOP("Eds", "\"%1\" is no rate of CANopen in kBd, and what was meant is not guessed. Write "
                              "10, 20, 50, 100, 125, 250, 500, 800 or 1000.")},
    {EdsFault::noObjects,
     QT_TRANSLATE_NOOP("Eds", "There is no object in this file: it is no EDS and no DCF.")},
    {EdsFault::tooManyObjects,
     QT_TRANSLATE_NOOP("Eds", "This file has more than %1 objects: it is of no encoder.")},
});
static_assert(areInOrder(edsFaultRows, &TextOf<EdsFault>::id, EdsFault::tooManyObjects));

} // namespace

QString EdsNote::text() const
{
    return sentence(QCoreApplication::translate("Eds", rowOf(edsFaultRows, fault).text), parts);
}

void EdsNotes::add(EdsNote note)
{
    ++m_count;
    if (m_kept.size() < mostNotes)
        m_kept.push_back(std::move(note));
}

void EdsNotes::sort()
{
    std::ranges::stable_sort(m_kept, {}, &EdsNote::line);
}

} // namespace codewheel::canopen
