// SPDX-License-Identifier: MIT
#pragma once

class QAbstractSpinBox;
class QComboBox;

namespace view {

// Leaves undo and redo in a field that edits the document to the document, as number fields do; the field
// itself takes back only the text being typed.
void leaveUndoToDocument(QAbstractSpinBox* field);
void leaveUndoToDocument(QComboBox* field); // editable combo boxes

} // namespace view
