// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/kinds/interbus/offer/offer_wish.h"

#include <QStringList>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QRadioButton;
class QSpinBox;

namespace codewheel {

// Where and how a ring is to be offered. Part of OfferPage.
class OfferForm : public QWidget
{
    Q_OBJECT

public:
    explicit OfferForm(QWidget *parent = nullptr);

    // Those of this computer, beside 127.0.0.1 and 0.0.0.0. The chosen one stays.
    void setAddresses(const QStringList &addresses);
    void show(const OfferWish &wish);
    OfferWish wish() const; // without what is half typed

Q_SIGNALS:
    void edited();

private:
    void makeWhere(QFormLayout &form);
    void makeRings(QFormLayout &form);
    void addAddress(const QString &address);
    void choose(const QString &address);
    void showChoices();

    QComboBox *m_address;
    QLabel *m_warning;
    QSpinBox *m_port;
    QRadioButton *m_oneRing;
    QRadioButton *m_eachSeat;
    QSpinBox *m_seats;
    QCheckBox *m_readOnly;
};

} // namespace codewheel
