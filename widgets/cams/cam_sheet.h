// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"
#include "widgets/cams/cam_document.h"
#include "widgets/cams/cam_live.h"

#include <QPointer>

namespace codewheel {

// What the cam editor has open: a program of a document, the current cam, the range of positions, what the
// encoder is known to have, and what it shows now. Ruler, table and pictures show the same sheet and change
// the document through it.
class CamSheet : public QObject
{
    Q_OBJECT

public:
    using Gesture = CamDocument::Gesture;
    // What the encoder is known to have, and how: "It was read from the encoder. 14:02".
    struct KnownProgram
    {
        CamProgram program;
        QString how{};

        friend bool operator==(const KnownProgram &, const KnownProgram &) = default;
    };
    using KnownPrograms = std::array<std::optional<KnownProgram>, CamProgram::programs>;

    // Belongs to no encoder of the project until setDocument().
    explicit CamSheet(ProjectDocument &project, QObject *parent = nullptr);

    // The document must outlive its use here. abilities: those of its encoder.
    void setDocument(CamDocument &document, const CamAbilities &abilities = {});
    CamDocument &document() const { return *m_document; }

    const CamAbilities &abilities() const { return m_abilities; }
    unsigned number() const { return m_number; }
    void setNumber(unsigned number); // 1..abilities().programs
    const CamProgram &program() const { return m_document->program(m_number); }
    const Cam &cam(std::size_t cam) const { return program().cam.at(cam); }

    std::size_t current() const { return m_current; } // 0..abilities().cams - 1
    void setCurrent(std::size_t cam);

    // Nothing: not known; then any 25-bit position may be given.
    void setLargest(std::optional<std::int64_t> largest);
    std::int64_t largest() const;
    bool knowsLargest() const { return m_largest.has_value(); }
    // Whether the encoder can take it.
    Result<void> check(std::size_t number, const Cam &cam) const;

    void setKnown(const KnownPrograms &known);
    std::optional<CamProgram> known(unsigned number) const;
    QString howKnown(unsigned number) const; // empty: it is not
    // Nothing: the encoder's program is not known.
    std::optional<bool> differs(unsigned number) const;

    void setLive(const CamLive &live);
    const CamLive &live() const { return m_live; }
    bool isOld() const { return m_live.isOld; }      // what the encoder has is of before, too
    std::optional<bool> isOn(std::size_t cam) const; // now; nothing: not known

    // Undo steps. Where the positions do not form a circle, no cam passes through zero.
    void setCam(std::size_t cam, const Cam &value, const QString &what, Gesture gesture = {});
    void setActive(std::size_t cam, bool active);
    void clear(std::size_t cam);
    void setShift(unsigned shift, Gesture gesture = {});

Q_SIGNALS:
    void documentChanged();                // another document is shown
    void programChanged(unsigned program); // its content, or what the encoder is known to have
    void numberChanged(unsigned program);
    void currentChanged(std::size_t cam);
    void largestChanged();
    void liveChanged();

private:
    QPointer<CamDocument> m_document;
    CamAbilities m_abilities;
    unsigned m_number = 1;
    std::size_t m_current = 0;
    std::optional<std::int64_t> m_largest;
    KnownPrograms m_known;
    CamLive m_live;
};

} // namespace codewheel
