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

struct EdsFaultRows
{
    Q_DECLARE_TR_FUNCTIONS(Eds)

public:
    static constexpr auto all = std::to_array<TextOf<EdsFault>>({
        {EdsFault::notUtf8, QT_TR_NOOP("The text is not UTF-8, and is read as Latin-1: names may be wrong.")},
        {EdsFault::lettersLost, QT_TR_NOOP("Letters were lost before (U+FFFD): names may be wrong.")},
        {EdsFault::noEqualSign, QT_TR_NOOP("This is neither a section nor KEY=VALUE: the line is skipped.")},
        {EdsFault::beforeSections, QT_TR_NOOP("This is before the first section: the line is skipped.")},
        {EdsFault::bracketOpen, QT_TR_NOOP("The bracket is not closed: the line is read as a section.")},
        {EdsFault::behindBracket, QT_TR_NOOP("What is behind the section in this line is skipped.")},
        {EdsFault::unknownKey, QT_TR_NOOP("This key is not known: it is skipped.")},
        {EdsFault::unknownSection, QT_TR_NOOP("This section is not known: it is skipped.")},
        {EdsFault::ofModule, QT_TR_NOOP("This is for modules of the device: it is skipped.")},
        {EdsFault::keyTwice, QT_TR_NOOP("This key is here twice: the first one counts.")},
        {EdsFault::sectionTwice, QT_TR_NOOP("This section is here twice: the first one counts.")},
        {EdsFault::commentBehind, QT_TR_NOOP("What is behind the value is a comment.")},
        {EdsFault::leadingZero, QT_TR_NOOP("The leading zero does not mean octal: read as %1.")},
        {EdsFault::fraction, QT_TR_NOOP("This is an integer: read as %1.")},
        {EdsFault::suffix, QT_TR_NOOP("The letters behind the number mean nothing here: read as %1.")},
        {EdsFault::notANumber, QT_TR_NOOP("\"%1\" is no number: it counts as not stated.")},
        {EdsFault::doesNotFit, QT_TR_NOOP("\"%1\" does not fit into the type %2: it counts as not stated.")},
        {EdsFault::unknownType,
         QT_TR_NOOP("\"%1\" is no data type of CiA 301: the device tells how long the object is.")},
        {EdsFault::unknownObjectType,
         QT_TR_NOOP("\"%1\" is no object type of CiA 301: what has no subindexes counts as a variable.")},
        {EdsFault::unknownAccess,
         QT_TR_NOOP(
             "\"%1\" is no access: ro, wo, rw, rwr, rww or const is expected. It counts as not stated.")},
        {EdsFault::unknownMapping,
         QT_TR_NOOP(
             "\"%1\" does not say whether the object can be mapped: 0 or 1 is expected. It counts as 0.")},
        {EdsFault::lowOverHigh,
         QT_TR_NOOP("The low limit is above the high limit: both count as not stated.")},
        {EdsFault::nodeMissing,
         QT_TR_NOOP("\"%1\" lacks the number of the node ($NODEID): it is never written.")},
        {EdsFault::wrongCount, QT_TR_NOOP("The list announces %1 and has %2: it is read to its end.")},
        {EdsFault::noLists, QT_TR_NOOP("There are no lists of objects: the sections decide what there is.")},
        {EdsFault::noSection, QT_TR_NOOP("%1 is in the list and has no section: it is left out.")},
        {EdsFault::inNoList, QT_TR_NOOP("%1 has a section and is in no list: it is there.")},
        {EdsFault::inWrongList, QT_TR_NOOP("%1 is in the wrong list: its index decides whose object it is.")},
        {EdsFault::notInList, QT_TR_NOOP("\"%1\" is no index of an object: it is left out.")},
        {EdsFault::subsDiffer, QT_TR_NOOP("%1 subindexes are announced, and %2 are there: these count.")},
        {EdsFault::subAlone,
         QT_TR_NOOP("%1 has a subindex and no section of its own: the subindex is there.")},
        {EdsFault::noSubs, QT_TR_NOOP("%1 is to have subindexes and has none: it is left out.")},
        {EdsFault::tooManySubs, QT_TR_NOOP("%1 subindexes are more than there can be: it has %2.")},
        {EdsFault::otherCommissioning,
         QT_TR_NOOP("Node and rate are here twice, and differ: the first ones count.")},
        {EdsFault::badNode, QT_TR_NOOP("\"%1\" is no number of a node. Numbers go from 1 to 127; leave the "
                                       "value out where it is not set.")},
        {EdsFault::badRate, QT_TR_NOOP("\"%1\" is no rate of CANopen in kBd, and what was meant is not "
                                       "guessed. Write 10, 20, 50, 100, 125, 250, 500, 800 or 1000.")},
        {EdsFault::noObjects, QT_TR_NOOP("There is no object in this file: it is no EDS and no DCF.")},
        {EdsFault::tooManyObjects, QT_TR_NOOP("This file has more than %1 objects: it is of no encoder.")},
    });
};
static_assert(areInOrder(EdsFaultRows::all, &TextOf<EdsFault>::id, EdsFault::tooManyObjects));

} // namespace

QString EdsNote::text() const
{
    return sentence(QCoreApplication::translate("Eds", rowOf(EdsFaultRows::all, fault).text), parts);
}

void EdsNotes::add(EdsNote note)
{
    ++m_count;
    if (m_kept.size() < mostNotes)
        m_kept.push_back(std::move(note));
}

} // namespace codewheel::canopen
