// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever is clicked, nothing is stored in an encoder, and no position is set, before a question was
// answered.
#include "app/window/help/menu_list.h"
#include "app/window/kinds/esc/esc_line_at_work.h"
#include "tests/app/window_test.h"
#include "tests/support/places.h"
#include "widgets/structure/structure_view.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QPointer>

#include <vector>

namespace codewheel {
namespace {

class NothingUnasked : public test::WindowTest
{
protected:
    NothingUnasked()
    {
        m_refusing.setInterval(1);
        QObject::connect(&m_refusing, &QTimer::timeout, &m_refusing, [this] {
            if (auto *dialog = qobject_cast<QDialog *>(QApplication::activeModalWidget())) {
                ++m_refused;
                dialog->reject();
            } else if (QWidget *menu = QApplication::activePopupWidget()) {
                menu->close();
            }
        });
        m_refusing.start();
        shown->line().session()->setOperate(true);
        advance(500);
    }

    std::vector<EncoderSession *> encoders()
    {
        std::vector<EncoderSession *> all;
        for (const Place place : shown->buses().places())
            if (EncoderSession *encoder = shown->buses().encoder(place))
                all.push_back(encoder);
        return all;
    }
    int writes()
    {
        int sum = 0;
        for (const EncoderSession *encoder : encoders())
            sum += encoder->eepromWrites();
        return sum;
    }
    // A job that only reads may have begun; what is left of it is ended.
    void letItEnd()
    {
        for (int i = 0; i < 20; ++i) {
            advance(50);
            for (EncoderSession *encoder : encoders())
                if (encoder->runningJob())
                    encoder->cancel(OnCancel::leaveAsIs);
        }
    }
    void trigger(QAction &action)
    {
        const std::string what = action.text().toStdString() + " (" + action.objectName().toStdString() + ")";
        const int before = writes();
        action.trigger();
        advance(300);
        EXPECT_EQ(writes(), before) << what;
        ++m_triggered;
        letItEnd();
        EXPECT_EQ(writes(), before) << what;
    }

    QTimer m_refusing;
    int m_refused = 0;
    int m_triggered = 0;
};

TEST_F(NothingUnasked, NoActionStoresAnything)
{
    const Place onLine = shown->buses().places().back();
    ASSERT_FALSE(shown->buses().encoder(onLine)->device().hasWords());
    for (const Place place : {test::fraba, test::baumer, "5.0"_ring, onLine}) {
        SCOPED_TRACE(place.toString().toStdString());
        std::vector<QPointer<QAction>> actions;
        for (const ListedMenu &menu : menusOf(window()))
            for (QAction *action : menu.actions)
                actions.emplace_back(action);
        for (const QPointer<QAction> &action : actions) {
            if (!action || action->isSeparator() || action->menu() != nullptr ||
                action == this->actions().quit)
                continue;
            window().findChild<StructureView *>()->choose(place);
            advance(50);
            if (action && action->isEnabled() && action->isVisible())
                trigger(*action);
            if (!window().isVisible())
                window().show();
        }
    }
    EXPECT_GE(m_triggered, 100);
    EXPECT_GE(m_refused, 4) << "what stores asks";
}

} // namespace
} // namespace codewheel
