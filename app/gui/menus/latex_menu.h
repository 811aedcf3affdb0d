// SPDX-License-Identifier: MIT
#pragma once

#include "actions/action_menu.h"
#include "document/fractal/fractal.h"

#include <functional>
#include <memory>

// Copies the entry in hand for a paper or a worksheet.
class LatexMenu : public ActionMenu {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    explicit LatexMenu(const MenuContext& context);

private:
    using Write = std::function<QByteArray(const document::Fractal&)>;
    // `package`: what a document needs to typeset it, empty for nothing.
    void copy(Write write, std::shared_ptr<const document::Fractal> fractal, const QString& package);
};
