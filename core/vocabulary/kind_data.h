// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>

namespace codewheel {

// Something whose meaning only one kind of bus or protocol knows: a value of any comparable type. Copies
// share it; it never changes.
class KindData
{
public:
    KindData() = default;
    template <typename T>
    explicit KindData(T value)
        : m_value(std::make_shared<const Of<T>>(std::move(value)))
    {}

    // Null: it is empty, or of another type.
    template <typename T>
    const T *as() const
    {
        const auto *held = dynamic_cast<const Of<T> *>(m_value.get());
        return held ? &held->value : nullptr;
    }

    friend bool operator==(const KindData &one, const KindData &other)
    {
        return one.m_value == other.m_value ||
               (one.m_value && other.m_value && one.m_value->isSame(*other.m_value));
    }

private:
    struct Any
    {
        virtual ~Any() = default;
        virtual bool isSame(const Any &other) const = 0;
    };
    template <typename T>
    struct Of final : Any
    {
        explicit Of(T its)
            : value(std::move(its))
        {}
        bool isSame(const Any &other) const override
        {
            const auto *same = dynamic_cast<const Of *>(&other);
            return same != nullptr && same->value == value;
        }
        T value;
    };

    std::shared_ptr<const Any> m_value;
};

} // namespace codewheel
