// SPDX-License-Identifier: Apache-2.0
// Frames of noise through what GHDL's synthesis makes of stereo_ip_tiny, in a simulator of four values. Ends with the
// disparities that came, those of them that are not known, and the clocks with flags that are not known.
module tb_unknown;
   localparam frames = 3, width_px = 32, height_px = 12;
   reg aclk = 0, aresetn = 0, s_axis_tvalid = 0, s_axis_tuser, s_axis_tlast;
   reg [15:0] s_axis_tdata;
   wire s_axis_tready, m_axis_tvalid, m_axis_tlast, irq;
   wire [15:0] m_axis_tdata;
   wire [1:0] m_axis_tuser;
   integer beat, beats = 0, unknown = 0, unknown_flags = 0;

   stereo_ip_tiny dut (
      .aclk(aclk), .aresetn(aresetn), .s_axis_tvalid(s_axis_tvalid), .s_axis_tready(s_axis_tready),
      .s_axis_tdata(s_axis_tdata), .s_axis_tuser(s_axis_tuser), .s_axis_tlast(s_axis_tlast),
      .m_axis_tvalid(m_axis_tvalid), .m_axis_tready(1'b1), .m_axis_tdata(m_axis_tdata), .m_axis_tuser(m_axis_tuser),
      .m_axis_tlast(m_axis_tlast), .s_axil_awaddr(7'b0), .s_axil_awprot(3'b0), .s_axil_awvalid(1'b0),
      .s_axil_wdata(32'b0), .s_axil_wstrb(4'b0), .s_axil_wvalid(1'b0), .s_axil_bready(1'b0), .s_axil_araddr(7'b0),
      .s_axil_arprot(3'b0), .s_axil_arvalid(1'b0), .s_axil_rready(1'b0), .irq(irq));

   always #5 aclk = ~aclk;

   always @(posedge aclk) if (aresetn) begin
      if (^{m_axis_tvalid, m_axis_tuser, s_axis_tready, irq} === 1'bx) unknown_flags = unknown_flags + 1;
      if (m_axis_tvalid === 1'b1) begin
         beats = beats + 1;
         if (^{m_axis_tdata, m_axis_tlast} === 1'bx) unknown = unknown + 1;
      end
   end

   task pause;  // all inputs but tvalid are unknown
      begin
         s_axis_tvalid = 0;
         s_axis_tdata = 16'bx;
         s_axis_tuser = 1'bx;
         s_axis_tlast = 1'bx;
         repeat (100) @(negedge aclk);
      end
   endtask

   initial begin
      repeat (4) @(negedge aclk);
      aresetn = 1;
      for (beat = 0; beat < frames * width_px * height_px; beat = beat + 1) begin
         if (beat % (width_px * height_px) == 0) pause;
         s_axis_tvalid = 1;
         s_axis_tdata = $random;
         s_axis_tuser = beat % (width_px * height_px) == 0;
         s_axis_tlast = beat % width_px == width_px - 1;
         @(posedge aclk);
         while (!s_axis_tready) @(posedge aclk);
         @(negedge aclk);
      end
      repeat (3) pause;
      $display("%0d disparities, %0d unknown, %0d clocks with unknown flags", beats, unknown, unknown_flags);
      $finish;
   end
endmodule
