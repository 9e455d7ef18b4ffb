// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/screenshots/pictures.h"
#include "app/screenshots/scene.h"
#include "widgets/wizard/parameter_wizard.h"

#include <QDoubleSpinBox>

namespace codewheel {
namespace {

using namespace scene;

// Goes through the wizard up to this page.
QWidget *wizardAt(TrainingWindow &shown, ParameterWizard::Page page)
{
    shown.window().showWizard();
    auto *wizard = shown.window().findChild<ParameterWizard *>();
    while (wizard->page() < page) {
        if (wizard->page() == ParameterWizard::known)
            click(shown, "readAll");
        if (wizard->page() == ParameterWizard::handshake)
            while (wizard->isBusy())
                click(shown, "nextStep");
        click(shown, "wizardNext");
    }
    return wizard;
}

Picture shaftPicture(const char *name, ParameterWizard::Page page)
{
    return pictureOf(name, [page](TrainingWindow &shown) {
        want255(shown);
        return wizardAt(shown, page);
    });
}

QWidget *handshakeHalfWay(TrainingWindow &shown)
{
    want255(shown);
    QWidget *wizard = wizardAt(shown, ParameterWizard::handshake);
    click(shown, "nextStep");
    return wizard;
}

// 500 mm at 0.1 mm, from the calculator.
QWidget *rodValues(TrainingWindow &shown)
{
    choose(shown, rod);
    QWidget *wizard = wizardAt(shown, ParameterWizard::values);
    wizard->findChild<QDoubleSpinBox *>(QStringLiteral("rodLength"))->setValue(500);
    wizard->findChild<QDoubleSpinBox *>(QStringLiteral("rodResolution"))->setValue(0.1);
    click(shown, "rodUse");
    return wizard;
}

QWidget *rodHandshake(TrainingWindow &shown)
{
    rodValues(shown);
    QWidget *wizard = wizardAt(shown, ParameterWizard::handshake);
    click(shown, "nextStep");
    click(shown, "nextStep");
    return wizard;
}

} // namespace

std::vector<Picture> wizardPictures()
{
    return {
        shaftPicture("wizard-known", ParameterWizard::known),
        shaftPicture("wizard-values", ParameterWizard::values),
        shaftPicture("wizard-review", ParameterWizard::review),
        pictureOf("wizard-handshake", handshakeHalfWay),
        shaftPicture("wizard-report", ParameterWizard::report),
        pictureOf("wizard-rod-values", rodValues),
        pictureOf("wizard-rod-handshake", rodHandshake),
    };
}

} // namespace codewheel
