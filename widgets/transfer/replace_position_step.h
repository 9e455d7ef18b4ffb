// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transfer/last_positions.h"
#include "widgets/transfer/replace_step.h"

class QLabel;
class QLineEdit;
class QRadioButton;

namespace codewheel {

class InlineMessage;

// Which position the new encoder is to show: that of the previous one, as last seen or as kept in the
// project, one that is typed, or whatever it shows.
class ReplacePositionStep final : public ReplaceStep
{
    Q_OBJECT

public:
    ReplacePositionStep(Replacing &replacing, const LastPositions &positions, QWidget *parent = nullptr);

    void enter() override;
    bool leave() override;
    // Whether the position that was chosen is still the same place, and can be set, with what is wanted now.
    bool stillHolds() const;
    void askAnew(); // since it is not

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void lookAgain(); // at what happens on the bus meanwhile
    void askAgain(const QString &why);
    void showOffers();
    void preselect();
    void chooseNone();
    void noteChoice(bool isOn);
    bool isChosenOther() const;
    bool isOther(const SeenPosition &seen) const;
    bool isWantedOtherwise(const ParameterValues &scale) const;
    QString withScale(const QString &text, const ParameterValues &scale) const;
    QString textOf(const SeenPosition &seen) const; // %1 the position, %2 the time
    QString scaledText(const QString &text, const SeenPosition &seen) const;
    QString keptText(const SeenPosition &kept) const;
    static QString tipOf(const SeenPosition &seen);
    ParameterValues newSettings() const;
    std::optional<std::int64_t> newRange() const;
    void takeSeen(const SeenPosition &seen);
    void takeTyped();
    void refuseBeyondRange();
    QRadioButton *chosen() const;

    const LastPositions &m_positions;
    std::optional<SeenPosition> m_seen;
    std::optional<SeenPosition> m_since; // after it, of whichever encoder
    std::optional<SeenPosition> m_ofProject;
    bool m_isOther = false;    // what is chosen was marked as another position when it was
    bool m_mustChoose = false; // what was chosen has become another position
    QString m_whyAgain;
    ParameterValues m_scale;    // of the position that was chosen
    ParameterValues m_settings; // of the new encoder, when it was
    QRadioButton *m_last;
    QRadioButton *m_newest;
    QRadioButton *m_kept;
    QRadioButton *m_typed;
    QRadioButton *m_none;
    QLineEdit *m_value;
    QLabel *m_note;
    InlineMessage *m_message;
};

} // namespace codewheel
