// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QObject>
#include <QThreadPool>
#include <map>
#include <memory>

#include "core/document/document.h"
#include "ui/theme/colours.h"

namespace ew {

/// Small pictures of states of a document. They are made on another thread, each once, when they
/// are first asked for.
class StepPictures : public QObject {
    Q_OBJECT

  public:
    explicit StepPictures(QSize size, QObject* parent = nullptr);
    ~StepPictures() override;

    /// Null as long as it is not made; ready() follows then. Null for ever where there is no body.
    QImage picture(const std::shared_ptr<const DocumentState>& state);
    /// All pictures are made anew.
    void setLook(const ThemeColours& colours, double devicePixelRatio);

  signals:
    void ready();

  private:
    struct Kept {
        std::weak_ptr<const DocumentState> state;
        QImage image;
        bool made = false;
    };
    void make(const std::shared_ptr<const DocumentState>& state);
    void keep(const DocumentState* state, long look, const QImage& image);
    void forgetGone();

    QSize size_;
    const ThemeColours* colours_;
    double ratio_ = 1.0;
    long look_ = 0;  ///< counts setLook()
    std::map<const DocumentState*, Kept> kept_;
    std::shared_ptr<ShapeCache> cache_ = std::make_shared<ShapeCache>();
    QThreadPool pool_;
};

}  // namespace ew
