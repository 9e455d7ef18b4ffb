// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/label_text.h"

namespace codewheel {

QString plainLabel(QString label)
{
    for (auto mark = label.indexOf(u'&'); mark >= 0; mark = label.indexOf(u'&', mark + 1))
        label.remove(mark, 1); // the second one of "&&" is skipped, and so stays
    return label;
}

QString asLabel(QString text)
{
    return text.replace(u'&', QStringLiteral("&&"));
}

} // namespace codewheel
