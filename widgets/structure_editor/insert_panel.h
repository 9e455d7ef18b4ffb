// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/structure_editor/plan_edits.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QHBoxLayout;

namespace codewheel {

// Which device to insert, and where: among those in the catalog for this kind of bus, searched by name or ID
// code, or by ID code and length code if the kind has them. Part of the structure editor, which does the
// inserting.
class InsertPanel : public QWidget
{
    Q_OBJECT

public:
    // The edits must outlive it.
    explicit InsertPanel(const PlanEdits &edits, QWidget *parent = nullptr);

    void showKind(); // of the bus that is edited
    // As seen from this device, if any; `connected`: one that is chosen and not planned.
    void setPlace(std::optional<std::size_t> chosen, std::optional<NodeId> connected = {});
    void focusSearch();

Q_SIGNALS:
    void insertRequested(const codewheel::Participant &device, const codewheel::KindData &where);
    void changeRequested(const codewheel::Participant &device); // the current device into this one
    void closeRequested();

private:
    void makeFields();
    QHBoxLayout *makeSearchRow();
    void fillCatalog();
    void readCodes();
    void choose();
    std::optional<Participant> chosen() const;

    const PlanEdits &m_edits;
    bool m_hasChosen = false;
    std::vector<Participant> m_offered; // parallel to m_devices
    std::vector<PlanTarget> m_targets;  // parallel to m_where
    bool m_byCode = false;              // the codes were the last input
    QLineEdit *m_search;
    QListWidget *m_devices;
    QLineEdit *m_idCode;
    QLineEdit *m_lengthCode;
    QWidget *m_codes; // the row with the codes
    QLabel *m_codesLabel;
    QLabel *m_reading;
    QComboBox *m_where;
    QPushButton *m_insert;
    QPushButton *m_change;
};

} // namespace codewheel
