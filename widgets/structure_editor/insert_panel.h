// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ring/ring_edit.h"

#include <QWidget>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace codewheel {

class Catalog;

// Which device shall be inserted, and where: from the catalog, searched by name or ID code, or by ID code and
// length code. Stands in the structure editor, which carries it out.
class InsertPanel : public QWidget
{
    Q_OBJECT

public:
    explicit InsertPanel(const Catalog &catalog, QWidget *parent = nullptr);

    // Behind this device, and below it where it is a bus terminal. Null: at the end of the main line.
    void setPlace(const RingStructure &structure, std::optional<std::size_t> current);
    void focusSearch();

Q_SIGNALS:
    void insertRequested(const codewheel::Participant &device, const codewheel::RingPlace &place);
    void changeRequested(const codewheel::Participant &device); // the current one into this
    void closeRequested();

private:
    void makeFields();
    QHBoxLayout *makeSearchRow();
    void fillCatalog();
    void readCodes();
    void choose();
    std::optional<Participant> chosen() const;
    RingPlace place() const;
    void preferPlace();
    void fillPlaces();

    const Catalog &m_catalog;
    RingStructure m_structure;
    std::optional<std::size_t> m_current;
    std::vector<RingPlace> m_places; // as m_where
    bool m_byCode = false;           // the codes were typed last
    QLineEdit *m_search;
    QListWidget *m_devices;
    QLineEdit *m_idCode;
    QLineEdit *m_lengthCode;
    QLabel *m_reading;
    QComboBox *m_where;
    QPushButton *m_insert;
    QPushButton *m_change;
};

} // namespace codewheel
