// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/printed_view.h"

#include <QWidget>

class QLabel;
class QScrollBar;

namespace codewheel {

class CamProgramStrip;
class CamRuler;
class CamSheet;
class CamShiftSpin;
class CamTable;
class CamWordPicture;

// Where cams are edited: the eight programs, table and ruler side by side with matching rows, the shift with
// a picture of the word. Shows and changes the sheet; knows no encoder.
class CamBoard : public QWidget
{
    Q_OBJECT

public:
    explicit CamBoard(CamSheet &sheet, QWidget *parent = nullptr);

    void setNote(const QString &sentence); // what the encoder is doing
    // False while what is typed is bad; the focus is then back in its field.
    bool finishEditing();

    // Ruler, with all positions, and the word; what they tell; the table.
    void addTo(PrintedView &printed) const;

Q_SIGNALS:
    void programChosen(unsigned number);     // as typed or clicked; may be one that does not exist
    void inputChecked(const QString &wrong); // empty: good, or given up

private:
    QWidget *makeZoom();
    QWidget *makeWord();
    void connectParts();
    void showScale();
    void showShift();

    CamSheet &m_sheet;
    CamProgramStrip *m_strip;
    QLabel *m_note;
    CamTable *m_table;
    CamRuler *m_ruler;
    QScrollBar *m_scroll;
    QWidget *m_shifting = nullptr; // where part of the position is given beside the cams
    CamShiftSpin *m_shift;
    CamWordPicture *m_word;
};

} // namespace codewheel
