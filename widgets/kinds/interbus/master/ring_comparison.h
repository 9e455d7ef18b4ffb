// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/master_link.h"
#include "widgets/comparison/comparison_page.h"

namespace codewheel {

class RingSession;

// The comparison of a ring: lines can also be taken over into the configuration that the master keeps, and
// that configuration can be loaded back; all of it can be undone.
class RingComparison final : public ComparisonPage
{
    Q_OBJECT

public:
    QString effect() const override;
    // Both must outlive it.
    RingComparison(ProjectDocument &document, RingSession &bus, QWidget *parent = nullptr);

Q_SIGNALS:
    void readInRequested();

private:
    void showState() override;
    void showWhatIsPossible() override;
    RingStructure configured() const;
    int differencesOf(const KeptConfiguration &kept);
    void loadBack();
    void takeIntoMaster();
    void keep(KeptConfiguration configuration);
    bool mayChangeRing(); // if not, it says why
    void showKept(const std::optional<KeptConfiguration> &configuration);

    ProjectDocument &m_document;
    RingSession &m_ring;
    QPushButton *m_readIn;
    QPushButton *m_lineIntoMaster;
    QPushButton *m_allIntoMaster;
    QPushButton *m_keptIntoProject;
    std::optional<KeptConfiguration> m_kept;   // by the master, as it reported
    std::optional<KeptConfiguration> m_before; // replaced by a download
    bool m_isDownloading = false;
};

} // namespace codewheel
