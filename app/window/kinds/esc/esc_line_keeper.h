// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/plan/esc_line_plan.h"
#include "vocabulary/place.h"

#include <QObject>

namespace codewheel {

class EncoderSession;
class ProjectDocument;
class EscLineAtWork;

// Keeps in the project what happens to its serial line, each change as an undo step. The training line is not
// the project's: nothing is kept of its encoders, which do not exist. Used by EscLineViews.
class EscLineKeeper : public QObject
{
    Q_OBJECT

public:
    // Both must outlive it.
    EscLineKeeper(const EscLineAtWork &line, ProjectDocument &project, QObject *parent = nullptr);

    // The project's line; if it has none, the open one, or else factory settings.
    EscLinePlan line() const;

    // As it is open now, with these settings.
    void keepPort(const EscLinePlan &line);
    void keepFractionBits(int bits);
    void keepBaudRate(int baudRate);
    // Whether this encoder sends the bytes of its warnings in the other order.
    void keepByteOrder(Place number, bool isSwapped);
    // Encoders already in the project stay as they are.
    void keepEncoders(const std::vector<Place> &numbers);
    void removeEncoder(Place number);
    // Everything planned and known of the encoder moves along; the new address is no longer wanted.
    void moveEncoder(Place from, Place to);

private:
    const EncoderSession *sessionOf(Place number) const;
    void edit(const EscLinePlan &after, const QString &what);
    void edit(std::vector<ProjectDevice> after, const QString &what);
    std::vector<ProjectDevice> encoders() const; // of the project

    const EscLineAtWork &m_line;
    ProjectDocument &m_project;
};

} // namespace codewheel
