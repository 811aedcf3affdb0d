// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

class FileCommands;
class OpenFile;

namespace document {
class Document;
}
namespace view {
class CollectionPanel;
}

// Brings a choice from the collection to the window, as a document of its own or as entries of the open file.
// A fractal that keeps a fractal transformation is shown with its partner.
struct CollectionTarget {
    document::Document* document;
    OpenFile* file;
    FileCommands* commands; // asks before unsaved changes are discarded
    std::function<void()> showTransformation;
};
void connectCollection(view::CollectionPanel* collection, const CollectionTarget& target);
