// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/served_clients.h"
#include "widgets/kinds/interbus/offer/served_registers_model.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QTableView;
class QTabWidget;

namespace codewheel {

class RoleLabel;
class SeatsView;
class ServedClientsModel;

// Where a ring is offered, and how.
struct OfferedPlace
{
    QString address; // "127.0.0.1:1502"
    bool reachesOthers = false;
    bool readOnly = false;
    int seats = 0; // 0: one ring for all

    friend bool operator==(const OfferedPlace &, const OfferedPlace &) = default;
};

// A ring that is offered: where, who uses it, the seats, and the registers of its devices. Part of OfferPage.
class OfferedView : public QWidget
{
    Q_OBJECT

public:
    explicit OfferedView(QWidget *parent = nullptr);
    ~OfferedView() override;

    void setPlace(const OfferedPlace &place);
    void setDevices(std::vector<ServedDevice> devices);
    // Frame by frame.
    void showClients(const std::vector<ServedClient> &clients, const ClientCounts &counts);
    SeatsView &seats() { return *m_seats; }

private:
    QTableView *addTable(QAbstractItemModel &model, const char *id, const QString &name,
                         const QStringList &widest);
    QWidget *makeRegisters();
    void copy();

    OfferedPlace m_place;
    ServedClientsModel *m_clients;
    ServedRegistersModel *m_registers;
    RoleLabel *m_address;
    QPushButton *m_copy;
    QLabel *m_how;
    QLabel *m_counts;
    QTabWidget *m_tables;
    SeatsView *m_seats;
};

} // namespace codewheel
