// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

class CompareArea;
class Document;
class MessageLog;

/// Makes lights of the scene of the lamps that the views' environment has; a message says it where
/// there are none.
void takeLampsOut(Document& document, CompareArea& views, MessageLog& messages);

} // namespace patina
