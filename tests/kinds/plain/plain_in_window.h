// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/plant.h"
#include "app/window/kinds/window_kinds.h"
#include "project/bus_plans.h"
#include "tests/app/window_test.h"
#include "tests/kinds/plain/plain_bus.h"
#include "widgets/parameters/parameter_model.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/parameters/value_input.h"
#include "widgets/structure/structure_model.h"
#include "widgets/structure/structure_view.h"
#include "widgets/wizard/parameter_wizard.h"

#include <QLabel>
#include <QPushButton>
#include <QTreeView>

namespace codewheel::test {

class PlainBusAtWork final : public BusAtWork
{
public:
    PlainBusAtWork(BusId id, const Surroundings &its)
        : BusAtWork(id, its)
        , m_bus(its.catalog, allStations())
    {
        tellMessagesOf(m_bus);
    }

    QString kind() const override { return QStringLiteral("plain"); }
    PlainBus *bus() const override { return &m_bus; }

private:
    static std::vector<PlainStation> allStations()
    {
        std::vector<PlainStation> all = plainStations();
        std::ranges::copy(telegramStations(), std::back_inserter(all));
        return all;
    }

    mutable PlainBus m_bus;
};

inline constexpr Panel plainPanel{"plainDock", "Plain panel", Qt::ALT | Qt::SHIFT | Qt::Key_P,
                                  "README.md#the-window", Panel::Behind::state};
inline constexpr std::array plainPanels{&plainPanel};

class PlainViews final : public BusViews
{
public:
    PlainViews(const WindowParts &parts, QObject *parent)
        : BusViews(parent)
        , m_page(own(new QLabel(QStringLiteral("plain page"), &parts.pages)))
        , m_comparison(own(new QLabel(&parts.pages)))
    {
        parts.pages.addWidget(m_comparison);
    }

    std::vector<std::pair<const Panel *, QWidget *>> pages() const override
    {
        return {{&plainPanel, m_page}};
    }
    QWidget *comparison() const override { return m_comparison; }
    void open() override { Q_EMIT panelRequested(plainPanel); }

    QLabel *const m_page;

private:
    void showCurrent() override {}

    QLabel *const m_comparison;
};

// The window with that bus, planned and connected.
class PlainBusInWindow : public WindowTest
{
protected:
    static void SetUpTestSuite()
    {
        addBusKind(std::make_unique<PlainKind>());
        static bool isAdded = false;
        if (std::exchange(isAdded, true))
            return;
        addWindowKind({QStringLiteral("plain"),
                       [](BusId id, const BusAtWork::Surroundings &its) -> std::unique_ptr<BusAtWork> {
                           return std::make_unique<PlainBusAtWork>(id, its);
                       },
                       [](BusAtWork &, const WindowParts &parts, QObject *parent) -> BusViews * {
                           return new PlainViews(parts, parent);
                       },
                       plainPanels});
    }

    PlainBusInWindow()
    {
        Project project = shown->project().project();
        planBus(project, plainId, *busKind(u"plain")).name = QStringLiteral("Yard");
        shown->project().edit(project, QStringLiteral("Plan it"));
    }

    BusAtWork *plain() { return shown->plant().find(plainId); }
    PlainBus &plainBus() { return *static_cast<PlainBus *>(plain()->bus()); }
    StructureView &tree() { return *window().findChild<StructureView *>(); }
    std::string cell(Place place, StructureModel::Column column)
    {
        const auto &model = static_cast<const StructureModel &>(*tree().findChild<QTreeView *>()->model());
        return model.indexOf(place).siblingAtColumn(column).data().toString().toStdString();
    }
    ParameterPanel &panel() { return *window().findChild<ParameterPanel *>(); }
    void want(Parameter parameter, const QString &text) // by mouse and keys, in the panel
    {
        auto &table = *panel().findChild<ParameterTable *>();
        panel().showParameter(parameter);
        table.edit(table.currentIndex().siblingAtColumn(ParameterModel::wantedColumn));
        auto *field = qobject_cast<ValueInput *>(QApplication::focusWidget());
        ASSERT_NE(field, nullptr);
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
        QCoreApplication::processEvents();
    }
    void review()
    {
        for (auto *button : panel().findChildren<QPushButton *>())
            if (button->text() == QStringLiteral("&Write…"))
                QTest::mouseClick(button, Qt::LeftButton);
        advance(50);
    }
    void confirm()
    {
        QTest::mouseClick(panel().findChild<QPushButton *>(QStringLiteral("confirmWrite")), Qt::LeftButton);
        advance(100);
    }
    static bool says(const QWidget &view, const QString &text)
    {
        return std::ranges::any_of(view.findChildren<QLabel *>(), [&](const QLabel *label) {
            return label->isVisibleTo(&view) && label->text().contains(text);
        });
    }
    void clickInWizard(const char *button)
    {
        const auto all =
            window().findChild<ParameterWizard *>()->findChildren<QAbstractButton *>(QLatin1String(button));
        ASSERT_FALSE(all.empty()) << button;
        ASSERT_TRUE(all.front()->isVisible() && all.front()->isEnabled()) << button;
        all.front()->click();
        advance(50);
    }
};

} // namespace codewheel::test
