// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table_number.h"

#include "core/numbered_texts.h"

namespace patina {

int tableNumber(std::string_view file, TableForm form) {
    const int number = numberOfText(file);
    return number == 0 ? 0 : 2 * number + (form == TableForm::WithGrain ? 1 : 0);
}

std::string fileOfTable(int number) {
    return numberedText(number / 2);
}

TableForm formOfTable(int number) {
    return number % 2 == 1 ? TableForm::WithGrain : TableForm::WithoutGrain;
}

} // namespace patina
