// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/value_slider_accessible.h"

#include <QAccessibleWidget>

#include "parameters/value_slider.h"

namespace patina {

namespace {

class ValueSliderAccessible : public QAccessibleWidget, public QAccessibleValueInterface {
  public:
    explicit ValueSliderAccessible(ValueSlider* slider)
        : QAccessibleWidget(slider, QAccessible::Slider) {}

    void* interface_cast(QAccessible::InterfaceType type) override {
        if (type == QAccessible::ValueInterface) {
            return static_cast<QAccessibleValueInterface*>(this);
        }
        return QAccessibleWidget::interface_cast(type);
    }

    QVariant currentValue() const override { return slider()->value(); }
    QVariant minimumValue() const override { return slider()->range().lower(); }
    QVariant maximumValue() const override { return slider()->range().upper(); }
    QVariant minimumStepSize() const override { return slider()->range().step(); }

    void setCurrentValue(const QVariant& value) override {
        Q_EMIT slider()->jumped(value.toDouble());
    }

  private:
    ValueSlider* slider() const { return static_cast<ValueSlider*>(object()); }
};

QAccessibleInterface* makeInterface(const QString& className, QObject* object) {
    auto* slider = qobject_cast<ValueSlider*>(object);
    const bool isSlider =
        slider && className == QLatin1String(ValueSlider::staticMetaObject.className());
    return isSlider ? new ValueSliderAccessible(slider) : nullptr;
}

} // namespace

void installValueSliderAccessibility() {
    static const bool installed = [] {
        QAccessible::installFactory(makeInterface);
        return true;
    }();
    Q_UNUSED(installed);
}

} // namespace patina
