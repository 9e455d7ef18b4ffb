// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <cstdint>
#include <vector>

namespace codewheel::canopen {

// What was read in a device file otherwise than it is written, or not at all. The comment beside each lists
// what its sentence needs.
enum class EdsFault : std::uint8_t {
    notUtf8,
    lettersLost,
    noEqualSign,
    beforeSections,
    bracketOpen,
    behindBracket,
    unknownKey,
    unknownSection,
    ofModule,
    keyTwice,
    sectionTwice,
    commentBehind,
    leadingZero, // the number that was read
    fraction,    // likewise
    suffix,      // likewise
    notANumber,  // what is written
    doesNotFit,  // what is written, the type
    unknownType, // what is written
    unknownObjectType,
    unknownAccess,
    unknownMapping,
    lowOverHigh,
    nodeMissing, // what is written
    wrongCount,  // announced, there
    noLists,
    noSection,   // object
    inNoList,    // object
    inWrongList, // object
    notInList,   // what is written
    subsDiffer,  // announced, there
    subAlone,    // object
    noSubs,      // object
    tooManySubs, // announced, most
    otherCommissioning,
    badNode, // what is written
    badRate, // what is written
    // of the file as a whole
    noObjects,
    tooManyObjects, // most
};

struct EdsNote
{
    std::int64_t line = 0; // from 1; 0: the file as a whole
    QString key{};         // as it is written; of a section its name
    EdsFault fault = EdsFault::unknownKey;
    QStringList parts{};

    QString text() const; // a sentence in the user's language

    friend bool operator==(const EdsNote &, const EdsNote &) = default;
};

// The first thousand notes; of the others how many there are.
class EdsNotes
{
public:
    void add(EdsNote note);
    const std::vector<EdsNote> &kept() const { return m_kept; }
    std::size_t left() const { return m_count - m_kept.size(); }
    void sort() { std::ranges::stable_sort(m_kept, {}, &EdsNote::line); } // by line

private:
    std::vector<EdsNote> m_kept;
    std::size_t m_count = 0;
};

} // namespace codewheel::canopen
