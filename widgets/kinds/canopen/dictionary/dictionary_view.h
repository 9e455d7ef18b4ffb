// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/eds/eds_fault.h"
#include "widgets/kinds/canopen/dictionary/object_model.h"

#include <QPointer>
#include <QWidget>

#include <map>

class QAction;
class QComboBox;
class QLabel;
class QStackedWidget;
class QToolBar;

namespace codewheel {

struct DeviceDescription;
class CanopenSession;
class InlineMessage;
class LogTable;
class HeardValues;
class ObjectFilter;
class ObjectTransfers;
class ObjectWriteBar;

// What the project has of the objects of nodes, by node.
struct PlannedObjects
{
    std::map<int, std::vector<canopen::WantedObject>> wanted{};
    std::map<int, QString> files{}; // of each node that it has; empty: none

    friend bool operator==(const PlannedObjects &, const PlannedObjects &) = default;
};

// All objects of the chosen node, as a file of its maker has them, or else CiA 301 and CiA 406: they are
// read, compared with a file, written one by one, and kept as a DCF.
class DictionaryView : public QWidget
{
    Q_OBJECT

public:
    explicit DictionaryView(QWidget *parent = nullptr);
    ~DictionaryView() override;

    void setBus(codewheel::CanopenSession *bus); // null: none
    void setNode(std::optional<int> node);       // that of the chosen encoder
    void setRecordingChosen(bool isChosen);      // then nothing is sent
    void setPlanned(PlannedObjects planned);

    // Report on the spot what went wrong.
    bool openFile(const QString &path);
    bool compareWith(const QString &path);
    bool exportTo(const QString &path);

Q_SIGNALS:
    void fileChosen(int node, const QString &path); // empty: none any more

private:
    // What is known of a node.
    struct Known
    {
        canopen::DeviceFile file{};
        QString path{};      // empty: its description and the standards have it
        bool isRead = false; // `file` is that at `path`
        QString whyNot{};    // why not; empty: it was not tried
        QString deviceKey{}; // the description that has it
        std::vector<ObjectRow> rows{};
        std::optional<canopen::DeviceFile> comparedWith{};
        QString comparedPath{};
    };

    void makeTools(QToolBar &bar);
    void makeTable();
    QWidget *makeFilter();
    Known &known();
    void describeKnown(Known &its) const;
    void readKnownFile(Known &its);
    void followDescription();
    bool isDescribedAnew();
    const DeviceDescription *description() const;             // null: not known
    const std::vector<canopen::WantedObject> &wanted() const; // of the node
    void keepRows();
    void showRows();
    void renewRows();
    void showComparedColumns();
    bool canDiffer();
    void showSource();
    void showCounts();
    void showChosen();
    void showWhatIsPossible();
    void showProgress();
    QString whyNotSent() const;
    std::optional<canopen::FileObject> chosenObject() const;
    void readChosen();
    void readListed();
    void beginReading(const std::vector<canopen::SdoObject> &objects);
    void takeEnd(const canopen::SdoRequest &request, const canopen::SdoOutcome &outcome);
    std::optional<canopen::DeviceFile> fileAt(const QString &path);
    void takeHeard();
    canopen::DeviceFile fileNow(bool withHeard);
    void tellProject();
    QString doubtOf(const canopen::DeviceFile &file, const QString &path) const;
    void showDoubt();
    void compareAgain();
    void tellDifferences();
    void askOpen();
    void dropFile();
    void askCompare();
    void askExport();

    QPointer<CanopenSession> m_bus;
    bool m_isRecordingChosen = false;
    std::optional<int> m_node;
    std::map<int, Known> m_known; // by node
    PlannedObjects m_planned;
    QString m_doubt;           // about the file of the node
    std::size_t m_reading = 0; // objects that are to be read
    ObjectModel *m_rows;
    ObjectFilter *m_filter;
    ObjectTransfers *m_transfers;
    HeardValues *m_heard;
    LogTable *m_table;
    QStackedWidget *m_content;
    QLabel *m_source;
    QLabel *m_counts;
    QComboBox *m_group = nullptr;
    QAction *m_open = nullptr;
    QAction *m_drop = nullptr;
    QAction *m_read = nullptr;
    QAction *m_readAll = nullptr;
    QAction *m_cancel = nullptr;
    QAction *m_compare = nullptr;
    QAction *m_onlyDifferent = nullptr;
    QAction *m_export = nullptr;
    InlineMessage *m_message;
    ObjectWriteBar *m_writing;
};

} // namespace codewheel
