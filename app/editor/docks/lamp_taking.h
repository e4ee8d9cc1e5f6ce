// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

class CompareArea;
class Document;
class MessageLog;

/// Makes lights of the lamps in the active view's environment; adds a message if there are none.
void takeLampsOut(Document& document, CompareArea& views, MessageLog& messages);

} // namespace patina
