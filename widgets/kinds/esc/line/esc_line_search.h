// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/line/esc_line_event.h"
#include "widgets/look/page.h"

#include <QPointer>

class QCheckBox;
class QComboBox;
class QLayout;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QStackedWidget;
class QTableView;

namespace codewheel {

class EmptyState;
class FoundEncoderModel;
class InlineMessage;
class EscLineSession;

// Searches a serial line for encoders, shows what each reports of itself, and hands over the chosen ones.
// Sends reads only.
class EscLineSearch : public Page
{
    Q_OBJECT

public:
    // A kind of encoder that may be found.
    struct Device
    {
        QString key; // of the catalog
        QString name;
    };

    explicit EscLineSearch(QWidget *parent = nullptr);
    ~EscLineSearch() override;

    QString title() const override { return tr("Search for encoders"); }
    QString effect() const override
    {
        return tr("Asks encoders for their serial numbers. Nothing is written.");
    }

    void setLine(codewheel::EscLineSession *line); // null: none
    // What the found encoders may be: an encoder does not report its interface.
    void setDevices(const std::vector<Device> &devices);
    ScanWish wish() const;
    void setSettings(const ScanWish &wish);
    // By another search, before the line was connected; empty: nothing.
    void showFoundBefore(const std::vector<FoundEncoder> &found);
    // Says which of the wanted encoders could not be taken over because they answer at a baud rate other than
    // the line's.
    void showLeft(const std::vector<FoundEncoder> &left);
    // Says why one could not be taken over.
    void showRefused(const Refusal &why);

Q_SIGNALS:
    // Encoders of the line's own baud rate or of others; one with address 0 only by itself.
    void takeOverWanted(const std::vector<codewheel::FoundEncoder> &encoders, const QString &deviceKey);

private:
    void makeFields();
    void makeTable();
    QPushButton *addButton(QLayout &row, const QIcon &icon, const QString &text, const QString &toolTip);
    void start();
    void showProgress(const ScanProgress &progress);
    void showEnd(const ScanEnded &ended);
    void proposeKind(const std::vector<FoundEncoder> &found);
    void showFound(const std::vector<FoundEncoder> &found);
    void showWhatIsPossible();
    bool isConnected() const;

    QPointer<EscLineSession> m_line;
    bool m_isSearching = false;
    QSpinBox *m_first;
    QSpinBox *m_last;
    QComboBox *m_rates;
    QCheckBox *m_master;
    QComboBox *m_device;
    QPushButton *m_start = nullptr;
    QPushButton *m_cancel = nullptr;
    QPushButton *m_take = nullptr;
    QProgressBar *m_progress;
    InlineMessage *m_message;
    FoundEncoderModel *m_found;
    QStackedWidget *m_content;
    QTableView *m_table;
    EmptyState *m_empty;
};

} // namespace codewheel
