#pragma once
#include <string>
#include <vector>

#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

namespace cleave::app {

/// While it lives, VTK's errors and warnings are collected here instead of being printed.
class VtkMessages {
 public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  bool any() const;
  /// What VTK said, each message once, without its source places and addresses.
  std::string text() const;

 private:
  class Window;
  vtkSmartPointer<vtkOutputWindow> before_;
  vtkSmartPointer<Window> window_;
};

}  // namespace cleave::app
