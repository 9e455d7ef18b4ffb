// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/wanted_values.h"

#include "widgets/project/project_document.h"

#include <algorithm>
#include <set>

namespace codewheel {

void putWanted(ParameterValues &values, Parameter parameter, const std::optional<Value> &value)
{
    if (value)
        replaceValue(values, {parameter, *value});
    else
        std::erase_if(values, [&](const ParameterValue &each) { return each.parameter == parameter; });
}

WantedValues::WantedValues(ProjectDocument &project, QObject *parent)
    : QObject(parent)
    , m_project(project)
{
    tellChanges();
    connect(&m_project, &ProjectDocument::changed, this, &WantedValues::tellChanges);
}

std::optional<Value> WantedValues::value(Place number, Parameter parameter) const
{
    return findValue(values(number), parameter);
}

ParameterValues WantedValues::values(Place number) const
{
    return m_project.device(number).wanted;
}

void WantedValues::set(Place number, Parameter parameter, const std::optional<Value> &value)
{
    if (this->value(number, parameter) == value)
        return;
    const QString what = tr("%1 wanted for %2").arg(parameterName(parameter), number.shown());
    ParameterValues all = values(number);
    putWanted(all, parameter, value);
    replace(number, std::move(all), what);
}

void WantedValues::replace(Place number, ParameterValues values, const QString &what)
{
    std::ranges::sort(values, {}, &ParameterValue::parameter);
    if (values != this->values(number))
        m_project.editDevice(number, what, [&](ProjectDevice &device) { device.wanted = std::move(values); });
}

void WantedValues::clear(Place number)
{
    if (!values(number).empty())
        m_project.editDevice(number, tr("Nothing wanted for %1").arg(number.shown()),
                             [](ProjectDevice &device) { device.wanted.clear(); });
}

void WantedValues::tellChanges()
{
    std::map<Place, ParameterValues> now;
    m_project.forEachDevice([&](Place number, const ProjectDevice &device) {
        if (!device.wanted.empty())
            now[number] = device.wanted;
    });
    if (now == m_told)
        return;
    std::set<Place> others;
    for (const auto &[number, values] : now)
        if (const auto told = m_told.find(number); told == m_told.end() || told->second != values)
            others.insert(number);
    for (const auto &[number, values] : m_told)
        if (!now.contains(number))
            others.insert(number);
    m_told = std::move(now);
    for (const Place number : others)
        Q_EMIT changed(number);
}

} // namespace codewheel
