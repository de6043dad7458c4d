struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_12 {
member: type_2,
member_1: u32,
member_2: type_5,
member_3: type_7,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_5,
member_8: f32,
member_9: f32,
}
struct type_13 {
member: type_2,
member_1: u32,
member_2: type_2,
member_3: u32,
member_4: type_2,
member_5: u32,
member_6: type_4,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: type_5,
member_11: f32,
member_12: f32,
member_13: f32,
member_14: type_5,
member_15: type_5,
member_16: type_6,
member_17: type_5,
member_18: type_9,
member_19: type_11,
member_20: type_5,
member_21: type_12,
}
struct type_14 {
member: type_13,
}
struct type_16 {
member: array<f32>,
}
struct type_20 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: vec3<f32>,
member_13: i32,
member_14: i32,
member_15: f32,
}
struct type_22 {
member: array<u32>,
}
struct type_25 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(3)
var<storage> global_2: type_16;
@group(0) @binding(4)
var<storage, read_write> global_3: type_16;
@group(0) @binding(1)
var<storage> global_4: type_22;
@group(0) @binding(2)
var<storage> global_5: type_22;
@group(0) @binding(5)
var<storage, read_write> global_6: type_25;
fn function_() {
var local: i32;
var local_1: vec3<f32>;
var phi_711_: u32;
var phi_797_: i32;
var phi_800_: i32;
var phi_1236_: f32;
var phi_798_: i32;
var phi_801_: i32;
var local_2: i32;
var phi_1244_: type_20;
var phi_1246_: type_20;
var phi_1249_: i32;
var phi_1585_: f32;
var phi_1623_: i32;
var phi_1626_: i32;
var phi_2062_: f32;
var phi_1624_: i32;
var phi_1627_: i32;
var local_3: i32;
var phi_2074_: i32;
var phi_2077_: f32;
var phi_2079_: f32;
var phi_2108_: i32;
var phi_2111_: i32;
var phi_2547_: f32;
var phi_2109_: i32;
var phi_2112_: i32;
var local_4: i32;
var phi_2075_: i32;
var phi_2078_: f32;
var phi_2080_: f32;
var local_5: f32;
var local_6: f32;
var local_7: f32;
var phi_2582_: i32;
var phi_2585_: i32;
var phi_3021_: f32;
var phi_2583_: i32;
var phi_2586_: i32;
var local_8: i32;
var local_9: i32;
var phi_3481_: f32;
var phi_3920_: f32;
var phi_4360_: f32;
var phi_4799_: f32;
var phi_5239_: f32;
var phi_5678_: f32;
var local_10: f32;
var local_11: i32;
var local_12: f32;
var local_13: f32;
var local_14: f32;
var local_15: f32;
var local_16: f32;
var phi_6008_: type_20;
var local_17: i32;
var local_18: i32;
var phi_6225_: type_20;
var phi_6556_: type_20;
var phi_6609_: type_20;
var phi_6623_: type_20;
var local_19: i32;
var phi_7068_: type_20;
var phi_7069_: type_20;
var phi_7049_: type_20;
var phi_7070_: type_20;
var local_20: i32;
var phi_7078_: type_20;
var phi_7079_: type_20;
var phi_7080_: bool;
var phi_7659_: type_20;
var local_21: i32;
var phi_7961_: type_20;
var phi_7962_: type_20;
var phi_7963_: type_20;
var phi_7370_: type_20;
var phi_7964_: type_20;
var phi_1247_: type_20;
var phi_1250_: i32;
var local_22: type_20;
var local_23: type_20;
var local_24: type_20;
var local_25: type_20;
var local_26: type_20;
var local_27: type_20;
var local_28: type_20;
var local_29: type_20;
var local_30: type_20;
var local_31: type_20;
var local_32: type_20;
var local_33: type_20;
var local_34: type_20;
var local_35: type_20;
var local_36: type_20;
var local_37: type_20;
var local_38: type_20;
var local_39: type_20;
var local_40: type_20;
var local_41: type_20;
var local_42: type_20;
var local_43: type_20;
var local_44: type_20;
var local_45: type_20;
var local_46: type_20;
var local_47: type_20;
var local_48: type_20;
var local_49: f32;
let _e89 = global;
let _e95 = arrayLength((&global_5.member));
let _e97 = arrayLength((&global_2.member));
let _e104 = global_1.member.member;
if (_e89.x < _e104.member) {
if (_e89.y < _e104.member_1) {
let _e111 = (_e104.member * _e104.member_1);
let _e113 = ((_e89.y * _e104.member) + _e89.x);
let _e114 = bitcast<i32>(_e113);
let _e116 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e118 = select(_e116, _e114, (_e114 < _e116));
let _e124 = global_3.member[bitcast<u32>(select(0i, _e118, (_e118 > 0i)))];
let _e125 = (_e111 + _e113);
let _e126 = bitcast<i32>(_e125);
let _e128 = select(_e116, _e126, (_e126 < _e116));
let _e134 = global_3.member[bitcast<u32>(select(0i, _e128, (_e128 > 0i)))];
let _e136 = ((2u * _e111) + _e113);
let _e137 = bitcast<i32>(_e136);
let _e139 = select(_e116, _e137, (_e137 < _e116));
let _e145 = global_3.member[bitcast<u32>(select(0i, _e139, (_e139 > 0i)))];
let _e147 = ((3u * _e111) + _e113);
let _e148 = bitcast<i32>(_e147);
let _e150 = select(_e116, _e148, (_e148 < _e116));
let _e156 = global_3.member[bitcast<u32>(select(0i, _e150, (_e150 > 0i)))];
let _e158 = ((4u * _e111) + _e113);
let _e159 = bitcast<i32>(_e158);
let _e161 = select(_e116, _e159, (_e159 < _e116));
let _e167 = global_3.member[bitcast<u32>(select(0i, _e161, (_e161 > 0i)))];
let _e169 = ((5u * _e111) + _e113);
let _e170 = bitcast<i32>(_e169);
let _e172 = select(_e116, _e170, (_e170 < _e116));
let _e178 = global_3.member[bitcast<u32>(select(0i, _e172, (_e172 > 0i)))];
let _e180 = ((6u * _e111) + _e113);
let _e181 = bitcast<i32>(_e180);
let _e183 = select(_e116, _e181, (_e181 < _e116));
let _e189 = global_3.member[bitcast<u32>(select(0i, _e183, (_e183 > 0i)))];
let _e191 = ((7u * _e111) + _e113);
let _e192 = bitcast<i32>(_e191);
let _e194 = select(_e116, _e192, (_e192 < _e116));
let _e200 = global_3.member[bitcast<u32>(select(0i, _e194, (_e194 > 0i)))];
let _e202 = ((8u * _e111) + _e113);
let _e203 = bitcast<i32>(_e202);
let _e205 = select(_e116, _e203, (_e203 < _e116));
let _e211 = global_3.member[bitcast<u32>(select(0i, _e205, (_e205 > 0i)))];
let _e213 = ((9u * _e111) + _e113);
let _e214 = bitcast<i32>(_e213);
let _e216 = select(_e116, _e214, (_e214 < _e116));
let _e222 = global_3.member[bitcast<u32>(select(0i, _e216, (_e216 > 0i)))];
let _e224 = ((10u * _e111) + _e113);
let _e225 = bitcast<i32>(_e224);
let _e227 = select(_e116, _e225, (_e225 < _e116));
let _e233 = global_3.member[bitcast<u32>(select(0i, _e227, (_e227 > 0i)))];
let _e235 = ((11u * _e111) + _e113);
let _e236 = bitcast<i32>(_e235);
let _e238 = select(_e116, _e236, (_e236 < _e116));
let _e244 = global_3.member[bitcast<u32>(select(0i, _e238, (_e238 > 0i)))];
let _e246 = ((12u * _e111) + _e113);
let _e247 = bitcast<i32>(_e246);
let _e249 = select(_e116, _e247, (_e247 < _e116));
let _e255 = global_3.member[bitcast<u32>(select(0i, _e249, (_e249 > 0i)))];
let _e257 = ((13u * _e111) + _e113);
let _e258 = bitcast<i32>(_e257);
let _e260 = select(_e116, _e258, (_e258 < _e116));
let _e266 = global_3.member[bitcast<u32>(select(0i, _e260, (_e260 > 0i)))];
let _e268 = ((14u * _e111) + _e113);
let _e269 = bitcast<i32>(_e268);
let _e271 = select(_e116, _e269, (_e269 < _e116));
let _e277 = global_3.member[bitcast<u32>(select(0i, _e271, (_e271 > 0i)))];
let _e279 = ((15u * _e111) + _e113);
let _e280 = bitcast<i32>(_e279);
let _e282 = select(_e116, _e280, (_e280 < _e116));
let _e288 = global_3.member[bitcast<u32>(select(0i, _e282, (_e282 > 0i)))];
let _e290 = ((16u * _e111) + _e113);
let _e291 = bitcast<i32>(_e290);
let _e293 = select(_e116, _e291, (_e291 < _e116));
let _e299 = global_3.member[bitcast<u32>(select(0i, _e293, (_e293 > 0i)))];
let _e301 = ((17u * _e111) + _e113);
let _e302 = bitcast<i32>(_e301);
let _e304 = select(_e116, _e302, (_e302 < _e116));
let _e310 = global_3.member[bitcast<u32>(select(0i, _e304, (_e304 > 0i)))];
let _e312 = ((18u * _e111) + _e113);
let _e313 = bitcast<i32>(_e312);
let _e315 = select(_e116, _e313, (_e313 < _e116));
let _e321 = global_3.member[bitcast<u32>(select(0i, _e315, (_e315 > 0i)))];
let _e323 = ((19u * _e111) + _e113);
let _e324 = bitcast<i32>(_e323);
let _e326 = select(_e116, _e324, (_e324 < _e116));
let _e332 = global_3.member[bitcast<u32>(select(0i, _e326, (_e326 > 0i)))];
let _e334 = ((20u * _e111) + _e113);
let _e335 = bitcast<i32>(_e334);
let _e337 = select(_e116, _e335, (_e335 < _e116));
let _e343 = global_3.member[bitcast<u32>(select(0i, _e337, (_e337 > 0i)))];
let _e345 = ((21u * _e111) + _e113);
let _e346 = bitcast<i32>(_e345);
let _e348 = select(_e116, _e346, (_e346 < _e116));
let _e354 = global_3.member[bitcast<u32>(select(0i, _e348, (_e348 > 0i)))];
let _e356 = ((22u * _e111) + _e113);
let _e357 = bitcast<i32>(_e356);
let _e359 = select(_e116, _e357, (_e357 < _e116));
let _e365 = global_3.member[bitcast<u32>(select(0i, _e359, (_e359 > 0i)))];
let _e367 = ((23u * _e111) + _e113);
let _e368 = bitcast<i32>(_e367);
let _e370 = select(_e116, _e368, (_e368 < _e116));
let _e376 = global_3.member[bitcast<u32>(select(0i, _e370, (_e370 > 0i)))];
let _e378 = ((24u * _e111) + _e113);
let _e379 = bitcast<i32>(_e378);
let _e381 = select(_e116, _e379, (_e379 < _e116));
let _e387 = global_3.member[bitcast<u32>(select(0i, _e381, (_e381 > 0i)))];
let _e389 = ((25u * _e111) + _e113);
let _e390 = bitcast<i32>(_e389);
let _e392 = select(_e116, _e390, (_e390 < _e116));
let _e398 = global_3.member[bitcast<u32>(select(0i, _e392, (_e392 > 0i)))];
let _e400 = ((26u * _e111) + _e113);
let _e401 = bitcast<i32>(_e400);
let _e403 = select(_e116, _e401, (_e401 < _e116));
let _e409 = global_3.member[bitcast<u32>(select(0i, _e403, (_e403 > 0i)))];
let _e411 = ((27u * _e111) + _e113);
let _e412 = bitcast<i32>(_e411);
let _e414 = select(_e116, _e412, (_e412 < _e116));
let _e420 = global_3.member[bitcast<u32>(select(0i, _e414, (_e414 > 0i)))];
let _e421 = (_e299 == 0f);
if _e421 {
phi_711_ = 3u;
} else {
phi_711_ = select(0u, 1u, (_e299 == 4f));
}
let _e425 = phi_711_;
if (_e425 > 0u) {
if (arrayLength((&global_6.member)) >= 3u) {
let _e434 = atomicLoad((&global_6.member[0u]));
if (_e434 == 0u) {
atomicStore((&global_6.member[0u]), ((_e104.member + 7u) / 8u));
atomicStore((&global_6.member[1u]), ((_e104.member_1 + 7u) / 8u));
atomicStore((&global_6.member[2u]), 1u);
}
}
}
if (_e425 > 1u) {
let _e442 = vec3<f32>(_e124, _e134, _e145);
let _e443 = vec3<f32>(_e156, _e167, _e178);
let _e444 = vec3<f32>(_e189, _e200, _e211);
let _e445 = vec3<f32>(_e222, _e233, _e244);
let _e446 = vec3<f32>(_e255, _e266, _e277);
let _e454 = vec3<f32>(_e365, _e376, _e387);
let _e461 = select(0i, select(select(i32(_e398), i32(-2147483648), (_e398 < -2147483600f)), 2147483647i, (_e398 > 2147483500f)), (_e398 == _e398));
let _e468 = select(0i, select(select(i32(_e409), i32(-2147483648), (_e409 < -2147483600f)), 2147483647i, (_e409 > 2147483500f)), (_e409 == _e409));
let _e472 = global_1.member.member_14;
let _e478 = global_1.member.member_15;
if (_e421 && (_e321 == 0f)) {
let _e486 = global_1.member.member_3;
phi_797_ = (bitcast<i32>(_e486) - 1i);
phi_800_ = 16i;
loop {
let _e490 = phi_797_;
let _e492 = phi_800_;
local_2 = _e492;
let _e493 = (_e490 >= 0i);
if _e493 {
let _e497 = global_1.member.member_2.member;
let _e502 = global_1.member.member_2.member_1;
let _e507 = global_1.member.member_2.member_2;
let _e509 = (_e124 - 0.5f);
let _e510 = (_e134 - 0.5f);
let _e511 = (_e145 - 0.5f);
let _e513 = f32((bitcast<i32>(_e497) - 2i));
let _e515 = select(0f, _e509, (_e509 > 0f));
let _e517 = select(_e513, _e515, (_e515 < _e513));
let _e524 = select(0i, select(select(i32(_e517), i32(-2147483648), (_e517 < -2147483600f)), 2147483647i, (_e517 > 2147483500f)), (_e517 == _e517));
let _e528 = (_e524 - select(0i, 1i, (_e517 < f32(_e524))));
let _e530 = f32((bitcast<i32>(_e502) - 2i));
let _e532 = select(0f, _e510, (_e510 > 0f));
let _e534 = select(_e530, _e532, (_e532 < _e530));
let _e541 = select(0i, select(select(i32(_e534), i32(-2147483648), (_e534 < -2147483600f)), 2147483647i, (_e534 > 2147483500f)), (_e534 == _e534));
let _e545 = (_e541 - select(0i, 1i, (_e534 < f32(_e541))));
let _e547 = f32((bitcast<i32>(_e507) - 2i));
let _e549 = select(0f, _e511, (_e511 > 0f));
let _e551 = select(_e547, _e549, (_e549 < _e547));
let _e558 = select(0i, select(select(i32(_e551), i32(-2147483648), (_e551 < -2147483600f)), 2147483647i, (_e551 > 2147483500f)), (_e551 == _e551));
let _e562 = (_e558 - select(0i, 1i, (_e551 < f32(_e558))));
let _e563 = (_e490 * 4i);
let _e564 = (_e563 + 1i);
let _e566 = (bitcast<i32>(_e95) - 1i);
let _e568 = select(_e566, _e564, (_e564 < _e566));
let _e574 = global_5.member[bitcast<u32>(select(0i, _e568, (_e568 > 0i)))];
let _e575 = (_e563 + 2i);
let _e577 = select(_e566, _e575, (_e575 < _e566));
let _e583 = global_5.member[bitcast<u32>(select(0i, _e577, (_e577 > 0i)))];
let _e584 = (_e563 + 3i);
let _e586 = select(_e566, _e584, (_e584 < _e566));
let _e592 = global_5.member[bitcast<u32>(select(0i, _e586, (_e586 > 0i)))];
let _e595 = (_e528 - bitcast<i32>((_e574 & 65535u)));
let _e600 = bitcast<i32>((_e574 >> bitcast<u32>(16i)));
let _e605 = (_e545 - bitcast<i32>((_e583 & 65535u)));
let _e610 = bitcast<i32>((_e583 >> bitcast<u32>(16i)));
let _e615 = (_e562 - bitcast<i32>((_e592 & 65535u)));
if ((((_e595 >= 0i) && ((_e595 + 1i) < _e600)) && ((_e605 >= 0i) && ((_e605 + 1i) < _e610))) && ((_e615 >= 0i) && ((_e615 + 1i) < bitcast<i32>((_e592 >> bitcast<u32>(16i)))))) {
let _e625 = (_e610 * _e600);
let _e627 = select(_e566, _e563, (_e563 < _e566));
let _e633 = global_5.member[bitcast<u32>(select(0i, _e627, (_e627 > 0i)))];
let _e639 = (((bitcast<i32>(_e633) + (_e615 * _e625)) + (_e605 * _e600)) + _e595);
let _e641 = (_e509 - f32(_e528));
let _e643 = (_e510 - f32(_e545));
let _e646 = (2i * _e639);
let _e648 = (_e646 >> bitcast<u32>(2i));
let _e651 = bitcast<u32>(((_e646 & 3i) * 8i));
let _e653 = select(_e566, _e648, (_e648 < _e566));
let _e659 = global_5.member[bitcast<u32>(select(0i, _e653, (_e653 > 0i)))];
let _e663 = (_e648 + 1i);
let _e665 = select(_e566, _e663, (_e663 < _e566));
let _e671 = global_5.member[bitcast<u32>(select(0i, _e665, (_e665 > 0i)))];
let _e678 = ((_e659 >> bitcast<u32>((_e651 & 31u))) | ((_e671 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e651) & 31u))));
let _e681 = f32(bitcast<i32>((_e678 & 65535u)));
let _e688 = (_e681 + ((f32(bitcast<i32>((_e678 >> bitcast<u32>(16i)))) - _e681) * _e641));
let _e690 = (2i * (_e639 + _e600));
let _e692 = (_e690 >> bitcast<u32>(2i));
let _e695 = bitcast<u32>(((_e690 & 3i) * 8i));
let _e697 = select(_e566, _e692, (_e692 < _e566));
let _e703 = global_5.member[bitcast<u32>(select(0i, _e697, (_e697 > 0i)))];
let _e707 = (_e692 + 1i);
let _e709 = select(_e566, _e707, (_e707 < _e566));
let _e715 = global_5.member[bitcast<u32>(select(0i, _e709, (_e709 > 0i)))];
let _e722 = ((_e703 >> bitcast<u32>((_e695 & 31u))) | ((_e715 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e695) & 31u))));
let _e725 = f32(bitcast<i32>((_e722 & 65535u)));
let _e733 = (_e639 + _e625);
let _e734 = (2i * _e733);
let _e736 = (_e734 >> bitcast<u32>(2i));
let _e739 = bitcast<u32>(((_e734 & 3i) * 8i));
let _e741 = select(_e566, _e736, (_e736 < _e566));
let _e747 = global_5.member[bitcast<u32>(select(0i, _e741, (_e741 > 0i)))];
let _e751 = (_e736 + 1i);
let _e753 = select(_e566, _e751, (_e751 < _e566));
let _e759 = global_5.member[bitcast<u32>(select(0i, _e753, (_e753 > 0i)))];
let _e766 = ((_e747 >> bitcast<u32>((_e739 & 31u))) | ((_e759 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e739) & 31u))));
let _e769 = f32(bitcast<i32>((_e766 & 65535u)));
let _e776 = (_e769 + ((f32(bitcast<i32>((_e766 >> bitcast<u32>(16i)))) - _e769) * _e641));
let _e778 = (2i * (_e733 + _e600));
let _e780 = (_e778 >> bitcast<u32>(2i));
let _e783 = bitcast<u32>(((_e778 & 3i) * 8i));
let _e785 = select(_e566, _e780, (_e780 < _e566));
let _e791 = global_5.member[bitcast<u32>(select(0i, _e785, (_e785 > 0i)))];
let _e795 = (_e780 + 1i);
let _e797 = select(_e566, _e795, (_e795 < _e566));
let _e803 = global_5.member[bitcast<u32>(select(0i, _e797, (_e797 > 0i)))];
let _e810 = ((_e791 >> bitcast<u32>((_e783 & 31u))) | ((_e803 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e783) & 31u))));
let _e813 = f32(bitcast<i32>((_e810 & 65535u)));
let _e823 = (_e688 + (((_e725 + ((f32(bitcast<i32>((_e722 >> bitcast<u32>(16i)))) - _e725) * _e641)) - _e688) * _e643));
phi_1236_ = (_e823 + (((_e776 + (((_e813 + ((f32(bitcast<i32>((_e810 >> bitcast<u32>(16i)))) - _e813) * _e641)) - _e776) * _e643)) - _e823) * (_e511 - f32(_e562))));
} else {
phi_1236_ = 0f;
}
let _e831 = phi_1236_;
phi_798_ = (_e490 - 1i);
phi_801_ = select(_e492, _e490, (_e831 > 32767.5f));
} else {
phi_798_ = i32();
phi_801_ = i32();
}
let _e836 = phi_798_;
let _e838 = phi_801_;
continue;
continuing {
phi_797_ = _e836;
phi_800_ = _e838;
break if !(_e493);
}
}
let _e841 = local_2;
phi_1244_ = type_20(_e442, _e443, _e444, _e445, _e446, _e288, _e299, _e841, _e321, _e332, _e343, _e354, _e454, _e461, _e468, _e420);
} else {
phi_1244_ = type_20(_e442, _e443, _e444, _e445, _e446, _e288, _e299, select(0i, select(select(i32(_e310), i32(-2147483648), (_e310 < -2147483600f)), 2147483647i, (_e310 > 2147483500f)), (_e310 == _e310)), _e321, _e332, _e343, _e354, _e454, _e461, _e468, _e420);
}
let _e844 = phi_1244_;
phi_1246_ = _e844;
phi_1249_ = 0i;
loop {
let _e846 = phi_1246_;
let _e848 = phi_1249_;
local_22 = _e846;
local_23 = _e846;
local_24 = _e846;
local_25 = _e846;
local_26 = _e846;
local_27 = _e846;
local_28 = _e846;
local_29 = _e846;
local_30 = _e846;
local_31 = _e846;
local_32 = _e846;
local_33 = _e846;
local_34 = _e846;
local_35 = _e846;
local_36 = _e846;
local_37 = _e846;
local_38 = _e846;
local_39 = _e846;
local_40 = _e846;
local_41 = _e846;
local_42 = _e846;
local_43 = _e846;
local_44 = _e846;
local_45 = _e846;
local_46 = _e846;
local_47 = _e846;
local_48 = _e846;
let _e852 = ((_e848 < 256i) && (_e846.member_6 == 0f));
local_49 = _e846.member_6;
if _e852 {
let _e863 = (1f / select(_e846.member_1.x, select(1e-12f, -1e-12f, (_e846.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e846.member_1.x) & 2147483647u)) < 1e-12f)));
let _e872 = (1f / select(_e846.member_1.y, select(1e-12f, -1e-12f, (_e846.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e846.member_1.y) & 2147483647u)) < 1e-12f)));
let _e881 = (1f / select(_e846.member_1.z, select(1e-12f, -1e-12f, (_e846.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e846.member_1.z) & 2147483647u)) < 1e-12f)));
let _e885 = ((_e472.member - _e846.member.x) * _e863);
let _e887 = ((_e478.member - _e846.member.x) * _e863);
let _e890 = ((_e472.member_1 - _e846.member.y) * _e872);
let _e892 = ((_e478.member_1 - _e846.member.y) * _e872);
let _e895 = ((_e472.member_2 - _e846.member.z) * _e881);
let _e897 = ((_e478.member_2 - _e846.member.z) * _e881);
let _e899 = select(_e887, _e885, (_e885 > _e887));
let _e901 = select(_e892, _e890, (_e890 > _e892));
let _e903 = select(_e901, _e899, (_e899 < _e901));
let _e905 = select(_e897, _e895, (_e895 > _e897));
let _e907 = select(_e905, _e903, (_e903 < _e905));
let _e911 = global_1.member.member_4.member;
let _e912 = bitcast<i32>(_e911);
let _e916 = global_1.member.member_4.member_1;
let _e917 = bitcast<i32>(_e916);
let _e921 = global_1.member.member_4.member_2;
let _e924 = ((_e846.member.x - 0.5f) / 4f);
let _e926 = f32((_e912 - 1i));
let _e928 = select(0f, _e924, (_e924 > 0f));
let _e930 = select(_e926, _e928, (_e928 < _e926));
let _e937 = select(0i, select(select(i32(_e930), i32(-2147483648), (_e930 < -2147483600f)), 2147483647i, (_e930 > 2147483500f)), (_e930 == _e930));
let _e941 = (_e937 - select(0i, 1i, (_e930 < f32(_e937))));
let _e943 = ((_e846.member.y - 0.5f) / 4f);
let _e945 = f32((_e917 - 1i));
let _e947 = select(0f, _e943, (_e943 > 0f));
let _e949 = select(_e945, _e947, (_e947 < _e945));
let _e956 = select(0i, select(select(i32(_e949), i32(-2147483648), (_e949 < -2147483600f)), 2147483647i, (_e949 > 2147483500f)), (_e949 == _e949));
let _e960 = (_e956 - select(0i, 1i, (_e949 < f32(_e956))));
let _e962 = ((_e846.member.z - 0.5f) / 4f);
let _e964 = f32((bitcast<i32>(_e921) - 1i));
let _e966 = select(0f, _e962, (_e962 > 0f));
let _e968 = select(_e964, _e966, (_e966 < _e964));
let _e975 = select(0i, select(select(i32(_e968), i32(-2147483648), (_e968 < -2147483600f)), 2147483647i, (_e968 > 2147483500f)), (_e968 == _e968));
let _e979 = (_e975 - select(0i, 1i, (_e968 < f32(_e975))));
let _e983 = ((((_e979 * _e917) + _e960) * _e912) + _e941);
let _e985 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e987 = select(_e985, _e983, (_e983 < _e985));
let _e993 = global_4.member[bitcast<u32>(select(0i, _e987, (_e987 > 0i)))];
let _e994 = bitcast<i32>(_e993);
if (_e994 > 0i) {
let _e1024 = ((((f32(((_e941 - _e994) + 1i)) * 4f) + 0.5f) - _e846.member.x) * _e863);
let _e1026 = ((((f32((_e941 + _e994)) * 4f) + 0.5f) - _e846.member.x) * _e863);
let _e1028 = ((((f32(((_e960 - _e994) + 1i)) * 4f) + 0.5f) - _e846.member.y) * _e872);
let _e1030 = ((((f32((_e960 + _e994)) * 4f) + 0.5f) - _e846.member.y) * _e872);
let _e1032 = ((((f32(((_e979 - _e994) + 1i)) * 4f) + 0.5f) - _e846.member.z) * _e881);
let _e1034 = ((((f32((_e979 + _e994)) * 4f) + 0.5f) - _e846.member.z) * _e881);
let _e1036 = select(_e1026, _e1024, (_e1024 > _e1026));
let _e1038 = select(_e1030, _e1028, (_e1028 > _e1030));
let _e1040 = select(_e1038, _e1036, (_e1036 < _e1038));
let _e1042 = select(_e1034, _e1032, (_e1032 > _e1034));
let _e1044 = select(_e1042, _e1040, (_e1040 < _e1042));
phi_1585_ = (select(0f, _e1044, (_e1044 > 0f)) + 1e-3f);
} else {
phi_1585_ = 0.5f;
}
let _e1049 = phi_1585_;
let _e1052 = (select(0f, _e907, (_e907 > 0f)) + 1e-3f);
let _e1054 = select(_e1052, _e1049, (_e1049 < _e1052));
let _e1056 = (_e846.member_15 <= _e1054);
let _e1057 = select(_e1054, _e846.member_15, _e1056);
let _e1067 = global_1.member.member_3;
let _e1069 = (bitcast<i32>(_e1067) - 1i);
phi_1623_ = _e1069;
phi_1626_ = 16i;
loop {
let _e1071 = phi_1623_;
let _e1073 = phi_1626_;
local_3 = _e1073;
local_21 = _e1073;
let _e1074 = (_e1071 >= 0i);
if _e1074 {
let _e1078 = global_1.member.member_2.member;
let _e1083 = global_1.member.member_2.member_1;
let _e1088 = global_1.member.member_2.member_2;
let _e1090 = ((_e846.member.x + (_e846.member_1.x * _e1057)) - 0.5f);
let _e1091 = ((_e846.member.y + (_e846.member_1.y * _e1057)) - 0.5f);
let _e1092 = ((_e846.member.z + (_e846.member_1.z * _e1057)) - 0.5f);
let _e1094 = f32((bitcast<i32>(_e1078) - 2i));
let _e1096 = select(0f, _e1090, (_e1090 > 0f));
let _e1098 = select(_e1094, _e1096, (_e1096 < _e1094));
let _e1105 = select(0i, select(select(i32(_e1098), i32(-2147483648), (_e1098 < -2147483600f)), 2147483647i, (_e1098 > 2147483500f)), (_e1098 == _e1098));
let _e1109 = (_e1105 - select(0i, 1i, (_e1098 < f32(_e1105))));
let _e1111 = f32((bitcast<i32>(_e1083) - 2i));
let _e1113 = select(0f, _e1091, (_e1091 > 0f));
let _e1115 = select(_e1111, _e1113, (_e1113 < _e1111));
let _e1122 = select(0i, select(select(i32(_e1115), i32(-2147483648), (_e1115 < -2147483600f)), 2147483647i, (_e1115 > 2147483500f)), (_e1115 == _e1115));
let _e1126 = (_e1122 - select(0i, 1i, (_e1115 < f32(_e1122))));
let _e1128 = f32((bitcast<i32>(_e1088) - 2i));
let _e1130 = select(0f, _e1092, (_e1092 > 0f));
let _e1132 = select(_e1128, _e1130, (_e1130 < _e1128));
let _e1139 = select(0i, select(select(i32(_e1132), i32(-2147483648), (_e1132 < -2147483600f)), 2147483647i, (_e1132 > 2147483500f)), (_e1132 == _e1132));
let _e1143 = (_e1139 - select(0i, 1i, (_e1132 < f32(_e1139))));
let _e1144 = (_e1071 * 4i);
let _e1145 = (_e1144 + 1i);
let _e1147 = (bitcast<i32>(_e95) - 1i);
let _e1149 = select(_e1147, _e1145, (_e1145 < _e1147));
let _e1155 = global_5.member[bitcast<u32>(select(0i, _e1149, (_e1149 > 0i)))];
let _e1156 = (_e1144 + 2i);
let _e1158 = select(_e1147, _e1156, (_e1156 < _e1147));
let _e1164 = global_5.member[bitcast<u32>(select(0i, _e1158, (_e1158 > 0i)))];
let _e1165 = (_e1144 + 3i);
let _e1167 = select(_e1147, _e1165, (_e1165 < _e1147));
let _e1173 = global_5.member[bitcast<u32>(select(0i, _e1167, (_e1167 > 0i)))];
let _e1176 = (_e1109 - bitcast<i32>((_e1155 & 65535u)));
let _e1181 = bitcast<i32>((_e1155 >> bitcast<u32>(16i)));
let _e1186 = (_e1126 - bitcast<i32>((_e1164 & 65535u)));
let _e1191 = bitcast<i32>((_e1164 >> bitcast<u32>(16i)));
let _e1196 = (_e1143 - bitcast<i32>((_e1173 & 65535u)));
if ((((_e1176 >= 0i) && ((_e1176 + 1i) < _e1181)) && ((_e1186 >= 0i) && ((_e1186 + 1i) < _e1191))) && ((_e1196 >= 0i) && ((_e1196 + 1i) < bitcast<i32>((_e1173 >> bitcast<u32>(16i)))))) {
let _e1206 = (_e1191 * _e1181);
let _e1208 = select(_e1147, _e1144, (_e1144 < _e1147));
let _e1214 = global_5.member[bitcast<u32>(select(0i, _e1208, (_e1208 > 0i)))];
let _e1220 = (((bitcast<i32>(_e1214) + (_e1196 * _e1206)) + (_e1186 * _e1181)) + _e1176);
let _e1222 = (_e1090 - f32(_e1109));
let _e1224 = (_e1091 - f32(_e1126));
let _e1227 = (2i * _e1220);
let _e1229 = (_e1227 >> bitcast<u32>(2i));
let _e1232 = bitcast<u32>(((_e1227 & 3i) * 8i));
let _e1234 = select(_e1147, _e1229, (_e1229 < _e1147));
let _e1240 = global_5.member[bitcast<u32>(select(0i, _e1234, (_e1234 > 0i)))];
let _e1244 = (_e1229 + 1i);
let _e1246 = select(_e1147, _e1244, (_e1244 < _e1147));
let _e1252 = global_5.member[bitcast<u32>(select(0i, _e1246, (_e1246 > 0i)))];
let _e1259 = ((_e1240 >> bitcast<u32>((_e1232 & 31u))) | ((_e1252 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1232) & 31u))));
let _e1262 = f32(bitcast<i32>((_e1259 & 65535u)));
let _e1269 = (_e1262 + ((f32(bitcast<i32>((_e1259 >> bitcast<u32>(16i)))) - _e1262) * _e1222));
let _e1271 = (2i * (_e1220 + _e1181));
let _e1273 = (_e1271 >> bitcast<u32>(2i));
let _e1276 = bitcast<u32>(((_e1271 & 3i) * 8i));
let _e1278 = select(_e1147, _e1273, (_e1273 < _e1147));
let _e1284 = global_5.member[bitcast<u32>(select(0i, _e1278, (_e1278 > 0i)))];
let _e1288 = (_e1273 + 1i);
let _e1290 = select(_e1147, _e1288, (_e1288 < _e1147));
let _e1296 = global_5.member[bitcast<u32>(select(0i, _e1290, (_e1290 > 0i)))];
let _e1303 = ((_e1284 >> bitcast<u32>((_e1276 & 31u))) | ((_e1296 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1276) & 31u))));
let _e1306 = f32(bitcast<i32>((_e1303 & 65535u)));
let _e1314 = (_e1220 + _e1206);
let _e1315 = (2i * _e1314);
let _e1317 = (_e1315 >> bitcast<u32>(2i));
let _e1320 = bitcast<u32>(((_e1315 & 3i) * 8i));
let _e1322 = select(_e1147, _e1317, (_e1317 < _e1147));
let _e1328 = global_5.member[bitcast<u32>(select(0i, _e1322, (_e1322 > 0i)))];
let _e1332 = (_e1317 + 1i);
let _e1334 = select(_e1147, _e1332, (_e1332 < _e1147));
let _e1340 = global_5.member[bitcast<u32>(select(0i, _e1334, (_e1334 > 0i)))];
let _e1347 = ((_e1328 >> bitcast<u32>((_e1320 & 31u))) | ((_e1340 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1320) & 31u))));
let _e1350 = f32(bitcast<i32>((_e1347 & 65535u)));
let _e1357 = (_e1350 + ((f32(bitcast<i32>((_e1347 >> bitcast<u32>(16i)))) - _e1350) * _e1222));
let _e1359 = (2i * (_e1314 + _e1181));
let _e1361 = (_e1359 >> bitcast<u32>(2i));
let _e1364 = bitcast<u32>(((_e1359 & 3i) * 8i));
let _e1366 = select(_e1147, _e1361, (_e1361 < _e1147));
let _e1372 = global_5.member[bitcast<u32>(select(0i, _e1366, (_e1366 > 0i)))];
let _e1376 = (_e1361 + 1i);
let _e1378 = select(_e1147, _e1376, (_e1376 < _e1147));
let _e1384 = global_5.member[bitcast<u32>(select(0i, _e1378, (_e1378 > 0i)))];
let _e1391 = ((_e1372 >> bitcast<u32>((_e1364 & 31u))) | ((_e1384 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1364) & 31u))));
let _e1394 = f32(bitcast<i32>((_e1391 & 65535u)));
let _e1404 = (_e1269 + (((_e1306 + ((f32(bitcast<i32>((_e1303 >> bitcast<u32>(16i)))) - _e1306) * _e1222)) - _e1269) * _e1224));
phi_2062_ = (_e1404 + (((_e1357 + (((_e1394 + ((f32(bitcast<i32>((_e1391 >> bitcast<u32>(16i)))) - _e1394) * _e1222)) - _e1357) * _e1224)) - _e1404) * (_e1092 - f32(_e1143))));
} else {
phi_2062_ = 0f;
}
let _e1412 = phi_2062_;
phi_1624_ = (_e1071 - 1i);
phi_1627_ = select(_e1073, _e1071, (_e1412 > 32767.5f));
} else {
phi_1624_ = i32();
phi_1627_ = i32();
}
let _e1417 = phi_1624_;
let _e1419 = phi_1627_;
continue;
continuing {
phi_1623_ = _e1417;
phi_1626_ = _e1419;
break if !(_e1074);
}
}
let _e1422 = local_3;
let _e1423 = (_e1422 == _e846.member_7);
if _e1423 {
phi_7079_ = _e846;
phi_7080_ = _e1423;
} else {
phi_2074_ = 0i;
phi_2077_ = 0f;
phi_2079_ = _e1057;
loop {
let _e1425 = phi_2074_;
let _e1427 = phi_2077_;
let _e1429 = phi_2079_;
local_5 = _e1429;
local_6 = _e1429;
local_7 = _e1429;
local_10 = _e1429;
local_12 = _e1429;
local_13 = _e1429;
local_14 = _e1429;
local_15 = _e1429;
local_16 = _e1429;
let _e1430 = (_e1425 < 12i);
if _e1430 {
let _e1432 = (0.5f * (_e1427 + _e1429));
phi_2108_ = _e1069;
phi_2111_ = 16i;
loop {
let _e1440 = phi_2108_;
let _e1442 = phi_2111_;
local_4 = _e1442;
let _e1443 = (_e1440 >= 0i);
if _e1443 {
let _e1447 = global_1.member.member_2.member;
let _e1452 = global_1.member.member_2.member_1;
let _e1457 = global_1.member.member_2.member_2;
let _e1459 = ((_e846.member.x + (_e846.member_1.x * _e1432)) - 0.5f);
let _e1460 = ((_e846.member.y + (_e846.member_1.y * _e1432)) - 0.5f);
let _e1461 = ((_e846.member.z + (_e846.member_1.z * _e1432)) - 0.5f);
let _e1463 = f32((bitcast<i32>(_e1447) - 2i));
let _e1465 = select(0f, _e1459, (_e1459 > 0f));
let _e1467 = select(_e1463, _e1465, (_e1465 < _e1463));
let _e1474 = select(0i, select(select(i32(_e1467), i32(-2147483648), (_e1467 < -2147483600f)), 2147483647i, (_e1467 > 2147483500f)), (_e1467 == _e1467));
let _e1478 = (_e1474 - select(0i, 1i, (_e1467 < f32(_e1474))));
let _e1480 = f32((bitcast<i32>(_e1452) - 2i));
let _e1482 = select(0f, _e1460, (_e1460 > 0f));
let _e1484 = select(_e1480, _e1482, (_e1482 < _e1480));
let _e1491 = select(0i, select(select(i32(_e1484), i32(-2147483648), (_e1484 < -2147483600f)), 2147483647i, (_e1484 > 2147483500f)), (_e1484 == _e1484));
let _e1495 = (_e1491 - select(0i, 1i, (_e1484 < f32(_e1491))));
let _e1497 = f32((bitcast<i32>(_e1457) - 2i));
let _e1499 = select(0f, _e1461, (_e1461 > 0f));
let _e1501 = select(_e1497, _e1499, (_e1499 < _e1497));
let _e1508 = select(0i, select(select(i32(_e1501), i32(-2147483648), (_e1501 < -2147483600f)), 2147483647i, (_e1501 > 2147483500f)), (_e1501 == _e1501));
let _e1512 = (_e1508 - select(0i, 1i, (_e1501 < f32(_e1508))));
let _e1513 = (_e1440 * 4i);
let _e1514 = (_e1513 + 1i);
let _e1516 = (bitcast<i32>(_e95) - 1i);
let _e1518 = select(_e1516, _e1514, (_e1514 < _e1516));
let _e1524 = global_5.member[bitcast<u32>(select(0i, _e1518, (_e1518 > 0i)))];
let _e1525 = (_e1513 + 2i);
let _e1527 = select(_e1516, _e1525, (_e1525 < _e1516));
let _e1533 = global_5.member[bitcast<u32>(select(0i, _e1527, (_e1527 > 0i)))];
let _e1534 = (_e1513 + 3i);
let _e1536 = select(_e1516, _e1534, (_e1534 < _e1516));
let _e1542 = global_5.member[bitcast<u32>(select(0i, _e1536, (_e1536 > 0i)))];
let _e1545 = (_e1478 - bitcast<i32>((_e1524 & 65535u)));
let _e1550 = bitcast<i32>((_e1524 >> bitcast<u32>(16i)));
let _e1555 = (_e1495 - bitcast<i32>((_e1533 & 65535u)));
let _e1560 = bitcast<i32>((_e1533 >> bitcast<u32>(16i)));
let _e1565 = (_e1512 - bitcast<i32>((_e1542 & 65535u)));
if ((((_e1545 >= 0i) && ((_e1545 + 1i) < _e1550)) && ((_e1555 >= 0i) && ((_e1555 + 1i) < _e1560))) && ((_e1565 >= 0i) && ((_e1565 + 1i) < bitcast<i32>((_e1542 >> bitcast<u32>(16i)))))) {
let _e1575 = (_e1560 * _e1550);
let _e1577 = select(_e1516, _e1513, (_e1513 < _e1516));
let _e1583 = global_5.member[bitcast<u32>(select(0i, _e1577, (_e1577 > 0i)))];
let _e1589 = (((bitcast<i32>(_e1583) + (_e1565 * _e1575)) + (_e1555 * _e1550)) + _e1545);
let _e1591 = (_e1459 - f32(_e1478));
let _e1593 = (_e1460 - f32(_e1495));
let _e1596 = (2i * _e1589);
let _e1598 = (_e1596 >> bitcast<u32>(2i));
let _e1601 = bitcast<u32>(((_e1596 & 3i) * 8i));
let _e1603 = select(_e1516, _e1598, (_e1598 < _e1516));
let _e1609 = global_5.member[bitcast<u32>(select(0i, _e1603, (_e1603 > 0i)))];
let _e1613 = (_e1598 + 1i);
let _e1615 = select(_e1516, _e1613, (_e1613 < _e1516));
let _e1621 = global_5.member[bitcast<u32>(select(0i, _e1615, (_e1615 > 0i)))];
let _e1628 = ((_e1609 >> bitcast<u32>((_e1601 & 31u))) | ((_e1621 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1601) & 31u))));
let _e1631 = f32(bitcast<i32>((_e1628 & 65535u)));
let _e1638 = (_e1631 + ((f32(bitcast<i32>((_e1628 >> bitcast<u32>(16i)))) - _e1631) * _e1591));
let _e1640 = (2i * (_e1589 + _e1550));
let _e1642 = (_e1640 >> bitcast<u32>(2i));
let _e1645 = bitcast<u32>(((_e1640 & 3i) * 8i));
let _e1647 = select(_e1516, _e1642, (_e1642 < _e1516));
let _e1653 = global_5.member[bitcast<u32>(select(0i, _e1647, (_e1647 > 0i)))];
let _e1657 = (_e1642 + 1i);
let _e1659 = select(_e1516, _e1657, (_e1657 < _e1516));
let _e1665 = global_5.member[bitcast<u32>(select(0i, _e1659, (_e1659 > 0i)))];
let _e1672 = ((_e1653 >> bitcast<u32>((_e1645 & 31u))) | ((_e1665 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1645) & 31u))));
let _e1675 = f32(bitcast<i32>((_e1672 & 65535u)));
let _e1683 = (_e1589 + _e1575);
let _e1684 = (2i * _e1683);
let _e1686 = (_e1684 >> bitcast<u32>(2i));
let _e1689 = bitcast<u32>(((_e1684 & 3i) * 8i));
let _e1691 = select(_e1516, _e1686, (_e1686 < _e1516));
let _e1697 = global_5.member[bitcast<u32>(select(0i, _e1691, (_e1691 > 0i)))];
let _e1701 = (_e1686 + 1i);
let _e1703 = select(_e1516, _e1701, (_e1701 < _e1516));
let _e1709 = global_5.member[bitcast<u32>(select(0i, _e1703, (_e1703 > 0i)))];
let _e1716 = ((_e1697 >> bitcast<u32>((_e1689 & 31u))) | ((_e1709 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1689) & 31u))));
let _e1719 = f32(bitcast<i32>((_e1716 & 65535u)));
let _e1726 = (_e1719 + ((f32(bitcast<i32>((_e1716 >> bitcast<u32>(16i)))) - _e1719) * _e1591));
let _e1728 = (2i * (_e1683 + _e1550));
let _e1730 = (_e1728 >> bitcast<u32>(2i));
let _e1733 = bitcast<u32>(((_e1728 & 3i) * 8i));
let _e1735 = select(_e1516, _e1730, (_e1730 < _e1516));
let _e1741 = global_5.member[bitcast<u32>(select(0i, _e1735, (_e1735 > 0i)))];
let _e1745 = (_e1730 + 1i);
let _e1747 = select(_e1516, _e1745, (_e1745 < _e1516));
let _e1753 = global_5.member[bitcast<u32>(select(0i, _e1747, (_e1747 > 0i)))];
let _e1760 = ((_e1741 >> bitcast<u32>((_e1733 & 31u))) | ((_e1753 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1733) & 31u))));
let _e1763 = f32(bitcast<i32>((_e1760 & 65535u)));
let _e1773 = (_e1638 + (((_e1675 + ((f32(bitcast<i32>((_e1672 >> bitcast<u32>(16i)))) - _e1675) * _e1591)) - _e1638) * _e1593));
phi_2547_ = (_e1773 + (((_e1726 + (((_e1763 + ((f32(bitcast<i32>((_e1760 >> bitcast<u32>(16i)))) - _e1763) * _e1591)) - _e1726) * _e1593)) - _e1773) * (_e1461 - f32(_e1512))));
} else {
phi_2547_ = 0f;
}
let _e1781 = phi_2547_;
phi_2109_ = (_e1440 - 1i);
phi_2112_ = select(_e1442, _e1440, (_e1781 > 32767.5f));
} else {
phi_2109_ = i32();
phi_2112_ = i32();
}
let _e1786 = phi_2109_;
let _e1788 = phi_2112_;
continue;
continuing {
phi_2108_ = _e1786;
phi_2111_ = _e1788;
break if !(_e1443);
}
}
let _e1791 = local_4;
let _e1792 = (_e1791 == _e846.member_7);
phi_2075_ = (_e1425 + 1i);
phi_2078_ = select(_e1427, _e1432, _e1792);
phi_2080_ = select(_e1432, _e1429, _e1792);
} else {
phi_2075_ = i32();
phi_2078_ = f32();
phi_2080_ = f32();
}
let _e1797 = phi_2075_;
let _e1799 = phi_2078_;
let _e1801 = phi_2080_;
continue;
continuing {
phi_2074_ = _e1797;
phi_2077_ = _e1799;
phi_2079_ = _e1801;
break if !(_e1430);
}
}
let _e1804 = local_5;
let _e1805 = (_e846.member_1.x * _e1804);
let _e1807 = local_6;
let _e1808 = (_e846.member_1.y * _e1807);
let _e1810 = local_7;
let _e1811 = (_e846.member_1.z * _e1810);
phi_2582_ = _e1069;
phi_2585_ = 16i;
loop {
let _e1818 = phi_2582_;
let _e1820 = phi_2585_;
local_8 = _e1820;
local_9 = _e1820;
local_11 = _e1820;
local_17 = _e1820;
local_18 = _e1820;
local_19 = _e1820;
local_20 = _e1820;
let _e1821 = (_e1818 >= 0i);
if _e1821 {
let _e1825 = global_1.member.member_2.member;
let _e1830 = global_1.member.member_2.member_1;
let _e1835 = global_1.member.member_2.member_2;
let _e1837 = ((_e846.member.x + _e1805) - 0.5f);
let _e1838 = ((_e846.member.y + _e1808) - 0.5f);
let _e1839 = ((_e846.member.z + _e1811) - 0.5f);
let _e1841 = f32((bitcast<i32>(_e1825) - 2i));
let _e1843 = select(0f, _e1837, (_e1837 > 0f));
let _e1845 = select(_e1841, _e1843, (_e1843 < _e1841));
let _e1852 = select(0i, select(select(i32(_e1845), i32(-2147483648), (_e1845 < -2147483600f)), 2147483647i, (_e1845 > 2147483500f)), (_e1845 == _e1845));
let _e1856 = (_e1852 - select(0i, 1i, (_e1845 < f32(_e1852))));
let _e1858 = f32((bitcast<i32>(_e1830) - 2i));
let _e1860 = select(0f, _e1838, (_e1838 > 0f));
let _e1862 = select(_e1858, _e1860, (_e1860 < _e1858));
let _e1869 = select(0i, select(select(i32(_e1862), i32(-2147483648), (_e1862 < -2147483600f)), 2147483647i, (_e1862 > 2147483500f)), (_e1862 == _e1862));
let _e1873 = (_e1869 - select(0i, 1i, (_e1862 < f32(_e1869))));
let _e1875 = f32((bitcast<i32>(_e1835) - 2i));
let _e1877 = select(0f, _e1839, (_e1839 > 0f));
let _e1879 = select(_e1875, _e1877, (_e1877 < _e1875));
let _e1886 = select(0i, select(select(i32(_e1879), i32(-2147483648), (_e1879 < -2147483600f)), 2147483647i, (_e1879 > 2147483500f)), (_e1879 == _e1879));
let _e1890 = (_e1886 - select(0i, 1i, (_e1879 < f32(_e1886))));
let _e1891 = (_e1818 * 4i);
let _e1892 = (_e1891 + 1i);
let _e1894 = (bitcast<i32>(_e95) - 1i);
let _e1896 = select(_e1894, _e1892, (_e1892 < _e1894));
let _e1902 = global_5.member[bitcast<u32>(select(0i, _e1896, (_e1896 > 0i)))];
let _e1903 = (_e1891 + 2i);
let _e1905 = select(_e1894, _e1903, (_e1903 < _e1894));
let _e1911 = global_5.member[bitcast<u32>(select(0i, _e1905, (_e1905 > 0i)))];
let _e1912 = (_e1891 + 3i);
let _e1914 = select(_e1894, _e1912, (_e1912 < _e1894));
let _e1920 = global_5.member[bitcast<u32>(select(0i, _e1914, (_e1914 > 0i)))];
let _e1923 = (_e1856 - bitcast<i32>((_e1902 & 65535u)));
let _e1928 = bitcast<i32>((_e1902 >> bitcast<u32>(16i)));
let _e1933 = (_e1873 - bitcast<i32>((_e1911 & 65535u)));
let _e1938 = bitcast<i32>((_e1911 >> bitcast<u32>(16i)));
let _e1943 = (_e1890 - bitcast<i32>((_e1920 & 65535u)));
if ((((_e1923 >= 0i) && ((_e1923 + 1i) < _e1928)) && ((_e1933 >= 0i) && ((_e1933 + 1i) < _e1938))) && ((_e1943 >= 0i) && ((_e1943 + 1i) < bitcast<i32>((_e1920 >> bitcast<u32>(16i)))))) {
let _e1953 = (_e1938 * _e1928);
let _e1955 = select(_e1894, _e1891, (_e1891 < _e1894));
let _e1961 = global_5.member[bitcast<u32>(select(0i, _e1955, (_e1955 > 0i)))];
let _e1967 = (((bitcast<i32>(_e1961) + (_e1943 * _e1953)) + (_e1933 * _e1928)) + _e1923);
let _e1969 = (_e1837 - f32(_e1856));
let _e1971 = (_e1838 - f32(_e1873));
let _e1974 = (2i * _e1967);
let _e1976 = (_e1974 >> bitcast<u32>(2i));
let _e1979 = bitcast<u32>(((_e1974 & 3i) * 8i));
let _e1981 = select(_e1894, _e1976, (_e1976 < _e1894));
let _e1987 = global_5.member[bitcast<u32>(select(0i, _e1981, (_e1981 > 0i)))];
let _e1991 = (_e1976 + 1i);
let _e1993 = select(_e1894, _e1991, (_e1991 < _e1894));
let _e1999 = global_5.member[bitcast<u32>(select(0i, _e1993, (_e1993 > 0i)))];
let _e2006 = ((_e1987 >> bitcast<u32>((_e1979 & 31u))) | ((_e1999 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1979) & 31u))));
let _e2009 = f32(bitcast<i32>((_e2006 & 65535u)));
let _e2016 = (_e2009 + ((f32(bitcast<i32>((_e2006 >> bitcast<u32>(16i)))) - _e2009) * _e1969));
let _e2018 = (2i * (_e1967 + _e1928));
let _e2020 = (_e2018 >> bitcast<u32>(2i));
let _e2023 = bitcast<u32>(((_e2018 & 3i) * 8i));
let _e2025 = select(_e1894, _e2020, (_e2020 < _e1894));
let _e2031 = global_5.member[bitcast<u32>(select(0i, _e2025, (_e2025 > 0i)))];
let _e2035 = (_e2020 + 1i);
let _e2037 = select(_e1894, _e2035, (_e2035 < _e1894));
let _e2043 = global_5.member[bitcast<u32>(select(0i, _e2037, (_e2037 > 0i)))];
let _e2050 = ((_e2031 >> bitcast<u32>((_e2023 & 31u))) | ((_e2043 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2023) & 31u))));
let _e2053 = f32(bitcast<i32>((_e2050 & 65535u)));
let _e2061 = (_e1967 + _e1953);
let _e2062 = (2i * _e2061);
let _e2064 = (_e2062 >> bitcast<u32>(2i));
let _e2067 = bitcast<u32>(((_e2062 & 3i) * 8i));
let _e2069 = select(_e1894, _e2064, (_e2064 < _e1894));
let _e2075 = global_5.member[bitcast<u32>(select(0i, _e2069, (_e2069 > 0i)))];
let _e2079 = (_e2064 + 1i);
let _e2081 = select(_e1894, _e2079, (_e2079 < _e1894));
let _e2087 = global_5.member[bitcast<u32>(select(0i, _e2081, (_e2081 > 0i)))];
let _e2094 = ((_e2075 >> bitcast<u32>((_e2067 & 31u))) | ((_e2087 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2067) & 31u))));
let _e2097 = f32(bitcast<i32>((_e2094 & 65535u)));
let _e2104 = (_e2097 + ((f32(bitcast<i32>((_e2094 >> bitcast<u32>(16i)))) - _e2097) * _e1969));
let _e2106 = (2i * (_e2061 + _e1928));
let _e2108 = (_e2106 >> bitcast<u32>(2i));
let _e2111 = bitcast<u32>(((_e2106 & 3i) * 8i));
let _e2113 = select(_e1894, _e2108, (_e2108 < _e1894));
let _e2119 = global_5.member[bitcast<u32>(select(0i, _e2113, (_e2113 > 0i)))];
let _e2123 = (_e2108 + 1i);
let _e2125 = select(_e1894, _e2123, (_e2123 < _e1894));
let _e2131 = global_5.member[bitcast<u32>(select(0i, _e2125, (_e2125 > 0i)))];
let _e2138 = ((_e2119 >> bitcast<u32>((_e2111 & 31u))) | ((_e2131 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2111) & 31u))));
let _e2141 = f32(bitcast<i32>((_e2138 & 65535u)));
let _e2151 = (_e2016 + (((_e2053 + ((f32(bitcast<i32>((_e2050 >> bitcast<u32>(16i)))) - _e2053) * _e1969)) - _e2016) * _e1971));
phi_3021_ = (_e2151 + (((_e2104 + (((_e2141 + ((f32(bitcast<i32>((_e2138 >> bitcast<u32>(16i)))) - _e2141) * _e1969)) - _e2104) * _e1971)) - _e2151) * (_e1839 - f32(_e1890))));
} else {
phi_3021_ = 0f;
}
let _e2159 = phi_3021_;
phi_2583_ = (_e1818 - 1i);
phi_2586_ = select(_e1820, _e1818, (_e2159 > 32767.5f));
} else {
phi_2583_ = i32();
phi_2586_ = i32();
}
let _e2164 = phi_2583_;
let _e2166 = phi_2586_;
continue;
continuing {
phi_2582_ = _e2164;
phi_2585_ = _e2166;
break if !(_e1821);
}
}
let _e2169 = local_8;
let _e2172 = local_9;
local = select(_e846.member_7, _e2172, (_e2169 < _e846.member_7));
local_1 = (_e846.member + vec3<f32>(_e1805, _e1808, _e1811));
let _e2177 = local;
let _e2178 = local_1[0u];
let _e2180 = local_1[1u];
let _e2182 = local_1[2u];
let _e2186 = global_1.member.member_2.member;
let _e2190 = global_1.member.member_2.member_1;
let _e2194 = global_1.member.member_2.member_2;
let _e2196 = ((_e2178 + -1f) - 0.5f);
let _e2197 = ((_e2180 + 0f) - 0.5f);
let _e2198 = ((_e2182 + 0f) - 0.5f);
let _e2200 = f32((bitcast<i32>(_e2186) - 2i));
let _e2202 = select(0f, _e2196, (_e2196 > 0f));
let _e2204 = select(_e2200, _e2202, (_e2202 < _e2200));
let _e2211 = select(0i, select(select(i32(_e2204), i32(-2147483648), (_e2204 < -2147483600f)), 2147483647i, (_e2204 > 2147483500f)), (_e2204 == _e2204));
let _e2215 = (_e2211 - select(0i, 1i, (_e2204 < f32(_e2211))));
let _e2217 = f32((bitcast<i32>(_e2190) - 2i));
let _e2219 = select(0f, _e2197, (_e2197 > 0f));
let _e2221 = select(_e2217, _e2219, (_e2219 < _e2217));
let _e2228 = select(0i, select(select(i32(_e2221), i32(-2147483648), (_e2221 < -2147483600f)), 2147483647i, (_e2221 > 2147483500f)), (_e2221 == _e2221));
let _e2232 = (_e2228 - select(0i, 1i, (_e2221 < f32(_e2228))));
let _e2234 = f32((bitcast<i32>(_e2194) - 2i));
let _e2236 = select(0f, _e2198, (_e2198 > 0f));
let _e2238 = select(_e2234, _e2236, (_e2236 < _e2234));
let _e2245 = select(0i, select(select(i32(_e2238), i32(-2147483648), (_e2238 < -2147483600f)), 2147483647i, (_e2238 > 2147483500f)), (_e2238 == _e2238));
let _e2249 = (_e2245 - select(0i, 1i, (_e2238 < f32(_e2245))));
let _e2250 = (_e2177 * 4i);
let _e2251 = (_e2250 + 1i);
let _e2253 = (bitcast<i32>(_e95) - 1i);
let _e2255 = select(_e2253, _e2251, (_e2251 < _e2253));
let _e2260 = global_5.member[bitcast<u32>(select(0i, _e2255, (_e2255 > 0i)))];
let _e2261 = (_e2250 + 2i);
let _e2263 = select(_e2253, _e2261, (_e2261 < _e2253));
let _e2268 = global_5.member[bitcast<u32>(select(0i, _e2263, (_e2263 > 0i)))];
let _e2269 = (_e2250 + 3i);
let _e2271 = select(_e2253, _e2269, (_e2269 < _e2253));
let _e2276 = global_5.member[bitcast<u32>(select(0i, _e2271, (_e2271 > 0i)))];
let _e2279 = (_e2215 - bitcast<i32>((_e2260 & 65535u)));
let _e2284 = bitcast<i32>((_e2260 >> bitcast<u32>(16i)));
let _e2289 = (_e2232 - bitcast<i32>((_e2268 & 65535u)));
let _e2294 = bitcast<i32>((_e2268 >> bitcast<u32>(16i)));
let _e2299 = (_e2249 - bitcast<i32>((_e2276 & 65535u)));
if ((((_e2279 >= 0i) && ((_e2279 + 1i) < _e2284)) && ((_e2289 >= 0i) && ((_e2289 + 1i) < _e2294))) && ((_e2299 >= 0i) && ((_e2299 + 1i) < bitcast<i32>((_e2276 >> bitcast<u32>(16i)))))) {
let _e2309 = (_e2294 * _e2284);
let _e2311 = select(_e2253, _e2250, (_e2250 < _e2253));
let _e2316 = global_5.member[bitcast<u32>(select(0i, _e2311, (_e2311 > 0i)))];
let _e2322 = (((bitcast<i32>(_e2316) + (_e2299 * _e2309)) + (_e2289 * _e2284)) + _e2279);
let _e2324 = (_e2196 - f32(_e2215));
let _e2326 = (_e2197 - f32(_e2232));
let _e2329 = (2i * _e2322);
let _e2331 = (_e2329 >> bitcast<u32>(2i));
let _e2334 = bitcast<u32>(((_e2329 & 3i) * 8i));
let _e2336 = select(_e2253, _e2331, (_e2331 < _e2253));
let _e2341 = global_5.member[bitcast<u32>(select(0i, _e2336, (_e2336 > 0i)))];
let _e2345 = (_e2331 + 1i);
let _e2347 = select(_e2253, _e2345, (_e2345 < _e2253));
let _e2352 = global_5.member[bitcast<u32>(select(0i, _e2347, (_e2347 > 0i)))];
let _e2359 = ((_e2341 >> bitcast<u32>((_e2334 & 31u))) | ((_e2352 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2334) & 31u))));
let _e2362 = f32(bitcast<i32>((_e2359 & 65535u)));
let _e2369 = (_e2362 + ((f32(bitcast<i32>((_e2359 >> bitcast<u32>(16i)))) - _e2362) * _e2324));
let _e2371 = (2i * (_e2322 + _e2284));
let _e2373 = (_e2371 >> bitcast<u32>(2i));
let _e2376 = bitcast<u32>(((_e2371 & 3i) * 8i));
let _e2378 = select(_e2253, _e2373, (_e2373 < _e2253));
let _e2383 = global_5.member[bitcast<u32>(select(0i, _e2378, (_e2378 > 0i)))];
let _e2387 = (_e2373 + 1i);
let _e2389 = select(_e2253, _e2387, (_e2387 < _e2253));
let _e2394 = global_5.member[bitcast<u32>(select(0i, _e2389, (_e2389 > 0i)))];
let _e2401 = ((_e2383 >> bitcast<u32>((_e2376 & 31u))) | ((_e2394 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2376) & 31u))));
let _e2404 = f32(bitcast<i32>((_e2401 & 65535u)));
let _e2412 = (_e2322 + _e2309);
let _e2413 = (2i * _e2412);
let _e2415 = (_e2413 >> bitcast<u32>(2i));
let _e2418 = bitcast<u32>(((_e2413 & 3i) * 8i));
let _e2420 = select(_e2253, _e2415, (_e2415 < _e2253));
let _e2425 = global_5.member[bitcast<u32>(select(0i, _e2420, (_e2420 > 0i)))];
let _e2429 = (_e2415 + 1i);
let _e2431 = select(_e2253, _e2429, (_e2429 < _e2253));
let _e2436 = global_5.member[bitcast<u32>(select(0i, _e2431, (_e2431 > 0i)))];
let _e2443 = ((_e2425 >> bitcast<u32>((_e2418 & 31u))) | ((_e2436 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2418) & 31u))));
let _e2446 = f32(bitcast<i32>((_e2443 & 65535u)));
let _e2453 = (_e2446 + ((f32(bitcast<i32>((_e2443 >> bitcast<u32>(16i)))) - _e2446) * _e2324));
let _e2455 = (2i * (_e2412 + _e2284));
let _e2457 = (_e2455 >> bitcast<u32>(2i));
let _e2460 = bitcast<u32>(((_e2455 & 3i) * 8i));
let _e2462 = select(_e2253, _e2457, (_e2457 < _e2253));
let _e2467 = global_5.member[bitcast<u32>(select(0i, _e2462, (_e2462 > 0i)))];
let _e2471 = (_e2457 + 1i);
let _e2473 = select(_e2253, _e2471, (_e2471 < _e2253));
let _e2478 = global_5.member[bitcast<u32>(select(0i, _e2473, (_e2473 > 0i)))];
let _e2485 = ((_e2467 >> bitcast<u32>((_e2460 & 31u))) | ((_e2478 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2460) & 31u))));
let _e2488 = f32(bitcast<i32>((_e2485 & 65535u)));
let _e2498 = (_e2369 + (((_e2404 + ((f32(bitcast<i32>((_e2401 >> bitcast<u32>(16i)))) - _e2404) * _e2324)) - _e2369) * _e2326));
phi_3481_ = (_e2498 + (((_e2453 + (((_e2488 + ((f32(bitcast<i32>((_e2485 >> bitcast<u32>(16i)))) - _e2488) * _e2324)) - _e2453) * _e2326)) - _e2498) * (_e2198 - f32(_e2249))));
} else {
phi_3481_ = 0f;
}
let _e2506 = phi_3481_;
let _e2507 = local;
let _e2508 = local_1[0u];
let _e2510 = local_1[1u];
let _e2512 = local_1[2u];
let _e2514 = ((_e2508 + 1f) - 0.5f);
let _e2515 = ((_e2510 + 0f) - 0.5f);
let _e2516 = ((_e2512 + 0f) - 0.5f);
let _e2518 = select(0f, _e2514, (_e2514 > 0f));
let _e2520 = select(_e2200, _e2518, (_e2518 < _e2200));
let _e2527 = select(0i, select(select(i32(_e2520), i32(-2147483648), (_e2520 < -2147483600f)), 2147483647i, (_e2520 > 2147483500f)), (_e2520 == _e2520));
let _e2531 = (_e2527 - select(0i, 1i, (_e2520 < f32(_e2527))));
let _e2533 = select(0f, _e2515, (_e2515 > 0f));
let _e2535 = select(_e2217, _e2533, (_e2533 < _e2217));
let _e2542 = select(0i, select(select(i32(_e2535), i32(-2147483648), (_e2535 < -2147483600f)), 2147483647i, (_e2535 > 2147483500f)), (_e2535 == _e2535));
let _e2546 = (_e2542 - select(0i, 1i, (_e2535 < f32(_e2542))));
let _e2548 = select(0f, _e2516, (_e2516 > 0f));
let _e2550 = select(_e2234, _e2548, (_e2548 < _e2234));
let _e2557 = select(0i, select(select(i32(_e2550), i32(-2147483648), (_e2550 < -2147483600f)), 2147483647i, (_e2550 > 2147483500f)), (_e2550 == _e2550));
let _e2561 = (_e2557 - select(0i, 1i, (_e2550 < f32(_e2557))));
let _e2562 = (_e2507 * 4i);
let _e2563 = (_e2562 + 1i);
let _e2565 = select(_e2253, _e2563, (_e2563 < _e2253));
let _e2570 = global_5.member[bitcast<u32>(select(0i, _e2565, (_e2565 > 0i)))];
let _e2571 = (_e2562 + 2i);
let _e2573 = select(_e2253, _e2571, (_e2571 < _e2253));
let _e2578 = global_5.member[bitcast<u32>(select(0i, _e2573, (_e2573 > 0i)))];
let _e2579 = (_e2562 + 3i);
let _e2581 = select(_e2253, _e2579, (_e2579 < _e2253));
let _e2586 = global_5.member[bitcast<u32>(select(0i, _e2581, (_e2581 > 0i)))];
let _e2589 = (_e2531 - bitcast<i32>((_e2570 & 65535u)));
let _e2594 = bitcast<i32>((_e2570 >> bitcast<u32>(16i)));
let _e2599 = (_e2546 - bitcast<i32>((_e2578 & 65535u)));
let _e2604 = bitcast<i32>((_e2578 >> bitcast<u32>(16i)));
let _e2609 = (_e2561 - bitcast<i32>((_e2586 & 65535u)));
if ((((_e2589 >= 0i) && ((_e2589 + 1i) < _e2594)) && ((_e2599 >= 0i) && ((_e2599 + 1i) < _e2604))) && ((_e2609 >= 0i) && ((_e2609 + 1i) < bitcast<i32>((_e2586 >> bitcast<u32>(16i)))))) {
let _e2619 = (_e2604 * _e2594);
let _e2621 = select(_e2253, _e2562, (_e2562 < _e2253));
let _e2626 = global_5.member[bitcast<u32>(select(0i, _e2621, (_e2621 > 0i)))];
let _e2632 = (((bitcast<i32>(_e2626) + (_e2609 * _e2619)) + (_e2599 * _e2594)) + _e2589);
let _e2634 = (_e2514 - f32(_e2531));
let _e2636 = (_e2515 - f32(_e2546));
let _e2639 = (2i * _e2632);
let _e2641 = (_e2639 >> bitcast<u32>(2i));
let _e2644 = bitcast<u32>(((_e2639 & 3i) * 8i));
let _e2646 = select(_e2253, _e2641, (_e2641 < _e2253));
let _e2651 = global_5.member[bitcast<u32>(select(0i, _e2646, (_e2646 > 0i)))];
let _e2655 = (_e2641 + 1i);
let _e2657 = select(_e2253, _e2655, (_e2655 < _e2253));
let _e2662 = global_5.member[bitcast<u32>(select(0i, _e2657, (_e2657 > 0i)))];
let _e2669 = ((_e2651 >> bitcast<u32>((_e2644 & 31u))) | ((_e2662 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2644) & 31u))));
let _e2672 = f32(bitcast<i32>((_e2669 & 65535u)));
let _e2679 = (_e2672 + ((f32(bitcast<i32>((_e2669 >> bitcast<u32>(16i)))) - _e2672) * _e2634));
let _e2681 = (2i * (_e2632 + _e2594));
let _e2683 = (_e2681 >> bitcast<u32>(2i));
let _e2686 = bitcast<u32>(((_e2681 & 3i) * 8i));
let _e2688 = select(_e2253, _e2683, (_e2683 < _e2253));
let _e2693 = global_5.member[bitcast<u32>(select(0i, _e2688, (_e2688 > 0i)))];
let _e2697 = (_e2683 + 1i);
let _e2699 = select(_e2253, _e2697, (_e2697 < _e2253));
let _e2704 = global_5.member[bitcast<u32>(select(0i, _e2699, (_e2699 > 0i)))];
let _e2711 = ((_e2693 >> bitcast<u32>((_e2686 & 31u))) | ((_e2704 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2686) & 31u))));
let _e2714 = f32(bitcast<i32>((_e2711 & 65535u)));
let _e2722 = (_e2632 + _e2619);
let _e2723 = (2i * _e2722);
let _e2725 = (_e2723 >> bitcast<u32>(2i));
let _e2728 = bitcast<u32>(((_e2723 & 3i) * 8i));
let _e2730 = select(_e2253, _e2725, (_e2725 < _e2253));
let _e2735 = global_5.member[bitcast<u32>(select(0i, _e2730, (_e2730 > 0i)))];
let _e2739 = (_e2725 + 1i);
let _e2741 = select(_e2253, _e2739, (_e2739 < _e2253));
let _e2746 = global_5.member[bitcast<u32>(select(0i, _e2741, (_e2741 > 0i)))];
let _e2753 = ((_e2735 >> bitcast<u32>((_e2728 & 31u))) | ((_e2746 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2728) & 31u))));
let _e2756 = f32(bitcast<i32>((_e2753 & 65535u)));
let _e2763 = (_e2756 + ((f32(bitcast<i32>((_e2753 >> bitcast<u32>(16i)))) - _e2756) * _e2634));
let _e2765 = (2i * (_e2722 + _e2594));
let _e2767 = (_e2765 >> bitcast<u32>(2i));
let _e2770 = bitcast<u32>(((_e2765 & 3i) * 8i));
let _e2772 = select(_e2253, _e2767, (_e2767 < _e2253));
let _e2777 = global_5.member[bitcast<u32>(select(0i, _e2772, (_e2772 > 0i)))];
let _e2781 = (_e2767 + 1i);
let _e2783 = select(_e2253, _e2781, (_e2781 < _e2253));
let _e2788 = global_5.member[bitcast<u32>(select(0i, _e2783, (_e2783 > 0i)))];
let _e2795 = ((_e2777 >> bitcast<u32>((_e2770 & 31u))) | ((_e2788 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2770) & 31u))));
let _e2798 = f32(bitcast<i32>((_e2795 & 65535u)));
let _e2808 = (_e2679 + (((_e2714 + ((f32(bitcast<i32>((_e2711 >> bitcast<u32>(16i)))) - _e2714) * _e2634)) - _e2679) * _e2636));
phi_3920_ = (_e2808 + (((_e2763 + (((_e2798 + ((f32(bitcast<i32>((_e2795 >> bitcast<u32>(16i)))) - _e2798) * _e2634)) - _e2763) * _e2636)) - _e2808) * (_e2516 - f32(_e2561))));
} else {
phi_3920_ = 0f;
}
let _e2816 = phi_3920_;
let _e2817 = (_e2506 - _e2816);
let _e2818 = local;
let _e2819 = local_1[0u];
let _e2821 = local_1[1u];
let _e2823 = local_1[2u];
let _e2825 = ((_e2819 + 0f) - 0.5f);
let _e2826 = ((_e2821 + -1f) - 0.5f);
let _e2827 = ((_e2823 + 0f) - 0.5f);
let _e2829 = select(0f, _e2825, (_e2825 > 0f));
let _e2831 = select(_e2200, _e2829, (_e2829 < _e2200));
let _e2838 = select(0i, select(select(i32(_e2831), i32(-2147483648), (_e2831 < -2147483600f)), 2147483647i, (_e2831 > 2147483500f)), (_e2831 == _e2831));
let _e2842 = (_e2838 - select(0i, 1i, (_e2831 < f32(_e2838))));
let _e2844 = select(0f, _e2826, (_e2826 > 0f));
let _e2846 = select(_e2217, _e2844, (_e2844 < _e2217));
let _e2853 = select(0i, select(select(i32(_e2846), i32(-2147483648), (_e2846 < -2147483600f)), 2147483647i, (_e2846 > 2147483500f)), (_e2846 == _e2846));
let _e2857 = (_e2853 - select(0i, 1i, (_e2846 < f32(_e2853))));
let _e2859 = select(0f, _e2827, (_e2827 > 0f));
let _e2861 = select(_e2234, _e2859, (_e2859 < _e2234));
let _e2868 = select(0i, select(select(i32(_e2861), i32(-2147483648), (_e2861 < -2147483600f)), 2147483647i, (_e2861 > 2147483500f)), (_e2861 == _e2861));
let _e2872 = (_e2868 - select(0i, 1i, (_e2861 < f32(_e2868))));
let _e2873 = (_e2818 * 4i);
let _e2874 = (_e2873 + 1i);
let _e2876 = select(_e2253, _e2874, (_e2874 < _e2253));
let _e2881 = global_5.member[bitcast<u32>(select(0i, _e2876, (_e2876 > 0i)))];
let _e2882 = (_e2873 + 2i);
let _e2884 = select(_e2253, _e2882, (_e2882 < _e2253));
let _e2889 = global_5.member[bitcast<u32>(select(0i, _e2884, (_e2884 > 0i)))];
let _e2890 = (_e2873 + 3i);
let _e2892 = select(_e2253, _e2890, (_e2890 < _e2253));
let _e2897 = global_5.member[bitcast<u32>(select(0i, _e2892, (_e2892 > 0i)))];
let _e2900 = (_e2842 - bitcast<i32>((_e2881 & 65535u)));
let _e2905 = bitcast<i32>((_e2881 >> bitcast<u32>(16i)));
let _e2910 = (_e2857 - bitcast<i32>((_e2889 & 65535u)));
let _e2915 = bitcast<i32>((_e2889 >> bitcast<u32>(16i)));
let _e2920 = (_e2872 - bitcast<i32>((_e2897 & 65535u)));
if ((((_e2900 >= 0i) && ((_e2900 + 1i) < _e2905)) && ((_e2910 >= 0i) && ((_e2910 + 1i) < _e2915))) && ((_e2920 >= 0i) && ((_e2920 + 1i) < bitcast<i32>((_e2897 >> bitcast<u32>(16i)))))) {
let _e2930 = (_e2915 * _e2905);
let _e2932 = select(_e2253, _e2873, (_e2873 < _e2253));
let _e2937 = global_5.member[bitcast<u32>(select(0i, _e2932, (_e2932 > 0i)))];
let _e2943 = (((bitcast<i32>(_e2937) + (_e2920 * _e2930)) + (_e2910 * _e2905)) + _e2900);
let _e2945 = (_e2825 - f32(_e2842));
let _e2947 = (_e2826 - f32(_e2857));
let _e2950 = (2i * _e2943);
let _e2952 = (_e2950 >> bitcast<u32>(2i));
let _e2955 = bitcast<u32>(((_e2950 & 3i) * 8i));
let _e2957 = select(_e2253, _e2952, (_e2952 < _e2253));
let _e2962 = global_5.member[bitcast<u32>(select(0i, _e2957, (_e2957 > 0i)))];
let _e2966 = (_e2952 + 1i);
let _e2968 = select(_e2253, _e2966, (_e2966 < _e2253));
let _e2973 = global_5.member[bitcast<u32>(select(0i, _e2968, (_e2968 > 0i)))];
let _e2980 = ((_e2962 >> bitcast<u32>((_e2955 & 31u))) | ((_e2973 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2955) & 31u))));
let _e2983 = f32(bitcast<i32>((_e2980 & 65535u)));
let _e2990 = (_e2983 + ((f32(bitcast<i32>((_e2980 >> bitcast<u32>(16i)))) - _e2983) * _e2945));
let _e2992 = (2i * (_e2943 + _e2905));
let _e2994 = (_e2992 >> bitcast<u32>(2i));
let _e2997 = bitcast<u32>(((_e2992 & 3i) * 8i));
let _e2999 = select(_e2253, _e2994, (_e2994 < _e2253));
let _e3004 = global_5.member[bitcast<u32>(select(0i, _e2999, (_e2999 > 0i)))];
let _e3008 = (_e2994 + 1i);
let _e3010 = select(_e2253, _e3008, (_e3008 < _e2253));
let _e3015 = global_5.member[bitcast<u32>(select(0i, _e3010, (_e3010 > 0i)))];
let _e3022 = ((_e3004 >> bitcast<u32>((_e2997 & 31u))) | ((_e3015 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2997) & 31u))));
let _e3025 = f32(bitcast<i32>((_e3022 & 65535u)));
let _e3033 = (_e2943 + _e2930);
let _e3034 = (2i * _e3033);
let _e3036 = (_e3034 >> bitcast<u32>(2i));
let _e3039 = bitcast<u32>(((_e3034 & 3i) * 8i));
let _e3041 = select(_e2253, _e3036, (_e3036 < _e2253));
let _e3046 = global_5.member[bitcast<u32>(select(0i, _e3041, (_e3041 > 0i)))];
let _e3050 = (_e3036 + 1i);
let _e3052 = select(_e2253, _e3050, (_e3050 < _e2253));
let _e3057 = global_5.member[bitcast<u32>(select(0i, _e3052, (_e3052 > 0i)))];
let _e3064 = ((_e3046 >> bitcast<u32>((_e3039 & 31u))) | ((_e3057 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3039) & 31u))));
let _e3067 = f32(bitcast<i32>((_e3064 & 65535u)));
let _e3074 = (_e3067 + ((f32(bitcast<i32>((_e3064 >> bitcast<u32>(16i)))) - _e3067) * _e2945));
let _e3076 = (2i * (_e3033 + _e2905));
let _e3078 = (_e3076 >> bitcast<u32>(2i));
let _e3081 = bitcast<u32>(((_e3076 & 3i) * 8i));
let _e3083 = select(_e2253, _e3078, (_e3078 < _e2253));
let _e3088 = global_5.member[bitcast<u32>(select(0i, _e3083, (_e3083 > 0i)))];
let _e3092 = (_e3078 + 1i);
let _e3094 = select(_e2253, _e3092, (_e3092 < _e2253));
let _e3099 = global_5.member[bitcast<u32>(select(0i, _e3094, (_e3094 > 0i)))];
let _e3106 = ((_e3088 >> bitcast<u32>((_e3081 & 31u))) | ((_e3099 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3081) & 31u))));
let _e3109 = f32(bitcast<i32>((_e3106 & 65535u)));
let _e3119 = (_e2990 + (((_e3025 + ((f32(bitcast<i32>((_e3022 >> bitcast<u32>(16i)))) - _e3025) * _e2945)) - _e2990) * _e2947));
phi_4360_ = (_e3119 + (((_e3074 + (((_e3109 + ((f32(bitcast<i32>((_e3106 >> bitcast<u32>(16i)))) - _e3109) * _e2945)) - _e3074) * _e2947)) - _e3119) * (_e2827 - f32(_e2872))));
} else {
phi_4360_ = 0f;
}
let _e3127 = phi_4360_;
let _e3128 = local;
let _e3129 = local_1[0u];
let _e3131 = local_1[1u];
let _e3133 = local_1[2u];
let _e3135 = ((_e3129 + 0f) - 0.5f);
let _e3136 = ((_e3131 + 1f) - 0.5f);
let _e3137 = ((_e3133 + 0f) - 0.5f);
let _e3139 = select(0f, _e3135, (_e3135 > 0f));
let _e3141 = select(_e2200, _e3139, (_e3139 < _e2200));
let _e3148 = select(0i, select(select(i32(_e3141), i32(-2147483648), (_e3141 < -2147483600f)), 2147483647i, (_e3141 > 2147483500f)), (_e3141 == _e3141));
let _e3152 = (_e3148 - select(0i, 1i, (_e3141 < f32(_e3148))));
let _e3154 = select(0f, _e3136, (_e3136 > 0f));
let _e3156 = select(_e2217, _e3154, (_e3154 < _e2217));
let _e3163 = select(0i, select(select(i32(_e3156), i32(-2147483648), (_e3156 < -2147483600f)), 2147483647i, (_e3156 > 2147483500f)), (_e3156 == _e3156));
let _e3167 = (_e3163 - select(0i, 1i, (_e3156 < f32(_e3163))));
let _e3169 = select(0f, _e3137, (_e3137 > 0f));
let _e3171 = select(_e2234, _e3169, (_e3169 < _e2234));
let _e3178 = select(0i, select(select(i32(_e3171), i32(-2147483648), (_e3171 < -2147483600f)), 2147483647i, (_e3171 > 2147483500f)), (_e3171 == _e3171));
let _e3182 = (_e3178 - select(0i, 1i, (_e3171 < f32(_e3178))));
let _e3183 = (_e3128 * 4i);
let _e3184 = (_e3183 + 1i);
let _e3186 = select(_e2253, _e3184, (_e3184 < _e2253));
let _e3191 = global_5.member[bitcast<u32>(select(0i, _e3186, (_e3186 > 0i)))];
let _e3192 = (_e3183 + 2i);
let _e3194 = select(_e2253, _e3192, (_e3192 < _e2253));
let _e3199 = global_5.member[bitcast<u32>(select(0i, _e3194, (_e3194 > 0i)))];
let _e3200 = (_e3183 + 3i);
let _e3202 = select(_e2253, _e3200, (_e3200 < _e2253));
let _e3207 = global_5.member[bitcast<u32>(select(0i, _e3202, (_e3202 > 0i)))];
let _e3210 = (_e3152 - bitcast<i32>((_e3191 & 65535u)));
let _e3215 = bitcast<i32>((_e3191 >> bitcast<u32>(16i)));
let _e3220 = (_e3167 - bitcast<i32>((_e3199 & 65535u)));
let _e3225 = bitcast<i32>((_e3199 >> bitcast<u32>(16i)));
let _e3230 = (_e3182 - bitcast<i32>((_e3207 & 65535u)));
if ((((_e3210 >= 0i) && ((_e3210 + 1i) < _e3215)) && ((_e3220 >= 0i) && ((_e3220 + 1i) < _e3225))) && ((_e3230 >= 0i) && ((_e3230 + 1i) < bitcast<i32>((_e3207 >> bitcast<u32>(16i)))))) {
let _e3240 = (_e3225 * _e3215);
let _e3242 = select(_e2253, _e3183, (_e3183 < _e2253));
let _e3247 = global_5.member[bitcast<u32>(select(0i, _e3242, (_e3242 > 0i)))];
let _e3253 = (((bitcast<i32>(_e3247) + (_e3230 * _e3240)) + (_e3220 * _e3215)) + _e3210);
let _e3255 = (_e3135 - f32(_e3152));
let _e3257 = (_e3136 - f32(_e3167));
let _e3260 = (2i * _e3253);
let _e3262 = (_e3260 >> bitcast<u32>(2i));
let _e3265 = bitcast<u32>(((_e3260 & 3i) * 8i));
let _e3267 = select(_e2253, _e3262, (_e3262 < _e2253));
let _e3272 = global_5.member[bitcast<u32>(select(0i, _e3267, (_e3267 > 0i)))];
let _e3276 = (_e3262 + 1i);
let _e3278 = select(_e2253, _e3276, (_e3276 < _e2253));
let _e3283 = global_5.member[bitcast<u32>(select(0i, _e3278, (_e3278 > 0i)))];
let _e3290 = ((_e3272 >> bitcast<u32>((_e3265 & 31u))) | ((_e3283 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3265) & 31u))));
let _e3293 = f32(bitcast<i32>((_e3290 & 65535u)));
let _e3300 = (_e3293 + ((f32(bitcast<i32>((_e3290 >> bitcast<u32>(16i)))) - _e3293) * _e3255));
let _e3302 = (2i * (_e3253 + _e3215));
let _e3304 = (_e3302 >> bitcast<u32>(2i));
let _e3307 = bitcast<u32>(((_e3302 & 3i) * 8i));
let _e3309 = select(_e2253, _e3304, (_e3304 < _e2253));
let _e3314 = global_5.member[bitcast<u32>(select(0i, _e3309, (_e3309 > 0i)))];
let _e3318 = (_e3304 + 1i);
let _e3320 = select(_e2253, _e3318, (_e3318 < _e2253));
let _e3325 = global_5.member[bitcast<u32>(select(0i, _e3320, (_e3320 > 0i)))];
let _e3332 = ((_e3314 >> bitcast<u32>((_e3307 & 31u))) | ((_e3325 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3307) & 31u))));
let _e3335 = f32(bitcast<i32>((_e3332 & 65535u)));
let _e3343 = (_e3253 + _e3240);
let _e3344 = (2i * _e3343);
let _e3346 = (_e3344 >> bitcast<u32>(2i));
let _e3349 = bitcast<u32>(((_e3344 & 3i) * 8i));
let _e3351 = select(_e2253, _e3346, (_e3346 < _e2253));
let _e3356 = global_5.member[bitcast<u32>(select(0i, _e3351, (_e3351 > 0i)))];
let _e3360 = (_e3346 + 1i);
let _e3362 = select(_e2253, _e3360, (_e3360 < _e2253));
let _e3367 = global_5.member[bitcast<u32>(select(0i, _e3362, (_e3362 > 0i)))];
let _e3374 = ((_e3356 >> bitcast<u32>((_e3349 & 31u))) | ((_e3367 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3349) & 31u))));
let _e3377 = f32(bitcast<i32>((_e3374 & 65535u)));
let _e3384 = (_e3377 + ((f32(bitcast<i32>((_e3374 >> bitcast<u32>(16i)))) - _e3377) * _e3255));
let _e3386 = (2i * (_e3343 + _e3215));
let _e3388 = (_e3386 >> bitcast<u32>(2i));
let _e3391 = bitcast<u32>(((_e3386 & 3i) * 8i));
let _e3393 = select(_e2253, _e3388, (_e3388 < _e2253));
let _e3398 = global_5.member[bitcast<u32>(select(0i, _e3393, (_e3393 > 0i)))];
let _e3402 = (_e3388 + 1i);
let _e3404 = select(_e2253, _e3402, (_e3402 < _e2253));
let _e3409 = global_5.member[bitcast<u32>(select(0i, _e3404, (_e3404 > 0i)))];
let _e3416 = ((_e3398 >> bitcast<u32>((_e3391 & 31u))) | ((_e3409 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3391) & 31u))));
let _e3419 = f32(bitcast<i32>((_e3416 & 65535u)));
let _e3429 = (_e3300 + (((_e3335 + ((f32(bitcast<i32>((_e3332 >> bitcast<u32>(16i)))) - _e3335) * _e3255)) - _e3300) * _e3257));
phi_4799_ = (_e3429 + (((_e3384 + (((_e3419 + ((f32(bitcast<i32>((_e3416 >> bitcast<u32>(16i)))) - _e3419) * _e3255)) - _e3384) * _e3257)) - _e3429) * (_e3137 - f32(_e3182))));
} else {
phi_4799_ = 0f;
}
let _e3437 = phi_4799_;
let _e3438 = (_e3127 - _e3437);
let _e3439 = local;
let _e3440 = local_1[0u];
let _e3442 = local_1[1u];
let _e3444 = local_1[2u];
let _e3446 = ((_e3440 + 0f) - 0.5f);
let _e3447 = ((_e3442 + 0f) - 0.5f);
let _e3448 = ((_e3444 + -1f) - 0.5f);
let _e3450 = select(0f, _e3446, (_e3446 > 0f));
let _e3452 = select(_e2200, _e3450, (_e3450 < _e2200));
let _e3459 = select(0i, select(select(i32(_e3452), i32(-2147483648), (_e3452 < -2147483600f)), 2147483647i, (_e3452 > 2147483500f)), (_e3452 == _e3452));
let _e3463 = (_e3459 - select(0i, 1i, (_e3452 < f32(_e3459))));
let _e3465 = select(0f, _e3447, (_e3447 > 0f));
let _e3467 = select(_e2217, _e3465, (_e3465 < _e2217));
let _e3474 = select(0i, select(select(i32(_e3467), i32(-2147483648), (_e3467 < -2147483600f)), 2147483647i, (_e3467 > 2147483500f)), (_e3467 == _e3467));
let _e3478 = (_e3474 - select(0i, 1i, (_e3467 < f32(_e3474))));
let _e3480 = select(0f, _e3448, (_e3448 > 0f));
let _e3482 = select(_e2234, _e3480, (_e3480 < _e2234));
let _e3489 = select(0i, select(select(i32(_e3482), i32(-2147483648), (_e3482 < -2147483600f)), 2147483647i, (_e3482 > 2147483500f)), (_e3482 == _e3482));
let _e3493 = (_e3489 - select(0i, 1i, (_e3482 < f32(_e3489))));
let _e3494 = (_e3439 * 4i);
let _e3495 = (_e3494 + 1i);
let _e3497 = select(_e2253, _e3495, (_e3495 < _e2253));
let _e3502 = global_5.member[bitcast<u32>(select(0i, _e3497, (_e3497 > 0i)))];
let _e3503 = (_e3494 + 2i);
let _e3505 = select(_e2253, _e3503, (_e3503 < _e2253));
let _e3510 = global_5.member[bitcast<u32>(select(0i, _e3505, (_e3505 > 0i)))];
let _e3511 = (_e3494 + 3i);
let _e3513 = select(_e2253, _e3511, (_e3511 < _e2253));
let _e3518 = global_5.member[bitcast<u32>(select(0i, _e3513, (_e3513 > 0i)))];
let _e3521 = (_e3463 - bitcast<i32>((_e3502 & 65535u)));
let _e3526 = bitcast<i32>((_e3502 >> bitcast<u32>(16i)));
let _e3531 = (_e3478 - bitcast<i32>((_e3510 & 65535u)));
let _e3536 = bitcast<i32>((_e3510 >> bitcast<u32>(16i)));
let _e3541 = (_e3493 - bitcast<i32>((_e3518 & 65535u)));
if ((((_e3521 >= 0i) && ((_e3521 + 1i) < _e3526)) && ((_e3531 >= 0i) && ((_e3531 + 1i) < _e3536))) && ((_e3541 >= 0i) && ((_e3541 + 1i) < bitcast<i32>((_e3518 >> bitcast<u32>(16i)))))) {
let _e3551 = (_e3536 * _e3526);
let _e3553 = select(_e2253, _e3494, (_e3494 < _e2253));
let _e3558 = global_5.member[bitcast<u32>(select(0i, _e3553, (_e3553 > 0i)))];
let _e3564 = (((bitcast<i32>(_e3558) + (_e3541 * _e3551)) + (_e3531 * _e3526)) + _e3521);
let _e3566 = (_e3446 - f32(_e3463));
let _e3568 = (_e3447 - f32(_e3478));
let _e3571 = (2i * _e3564);
let _e3573 = (_e3571 >> bitcast<u32>(2i));
let _e3576 = bitcast<u32>(((_e3571 & 3i) * 8i));
let _e3578 = select(_e2253, _e3573, (_e3573 < _e2253));
let _e3583 = global_5.member[bitcast<u32>(select(0i, _e3578, (_e3578 > 0i)))];
let _e3587 = (_e3573 + 1i);
let _e3589 = select(_e2253, _e3587, (_e3587 < _e2253));
let _e3594 = global_5.member[bitcast<u32>(select(0i, _e3589, (_e3589 > 0i)))];
let _e3601 = ((_e3583 >> bitcast<u32>((_e3576 & 31u))) | ((_e3594 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3576) & 31u))));
let _e3604 = f32(bitcast<i32>((_e3601 & 65535u)));
let _e3611 = (_e3604 + ((f32(bitcast<i32>((_e3601 >> bitcast<u32>(16i)))) - _e3604) * _e3566));
let _e3613 = (2i * (_e3564 + _e3526));
let _e3615 = (_e3613 >> bitcast<u32>(2i));
let _e3618 = bitcast<u32>(((_e3613 & 3i) * 8i));
let _e3620 = select(_e2253, _e3615, (_e3615 < _e2253));
let _e3625 = global_5.member[bitcast<u32>(select(0i, _e3620, (_e3620 > 0i)))];
let _e3629 = (_e3615 + 1i);
let _e3631 = select(_e2253, _e3629, (_e3629 < _e2253));
let _e3636 = global_5.member[bitcast<u32>(select(0i, _e3631, (_e3631 > 0i)))];
let _e3643 = ((_e3625 >> bitcast<u32>((_e3618 & 31u))) | ((_e3636 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3618) & 31u))));
let _e3646 = f32(bitcast<i32>((_e3643 & 65535u)));
let _e3654 = (_e3564 + _e3551);
let _e3655 = (2i * _e3654);
let _e3657 = (_e3655 >> bitcast<u32>(2i));
let _e3660 = bitcast<u32>(((_e3655 & 3i) * 8i));
let _e3662 = select(_e2253, _e3657, (_e3657 < _e2253));
let _e3667 = global_5.member[bitcast<u32>(select(0i, _e3662, (_e3662 > 0i)))];
let _e3671 = (_e3657 + 1i);
let _e3673 = select(_e2253, _e3671, (_e3671 < _e2253));
let _e3678 = global_5.member[bitcast<u32>(select(0i, _e3673, (_e3673 > 0i)))];
let _e3685 = ((_e3667 >> bitcast<u32>((_e3660 & 31u))) | ((_e3678 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3660) & 31u))));
let _e3688 = f32(bitcast<i32>((_e3685 & 65535u)));
let _e3695 = (_e3688 + ((f32(bitcast<i32>((_e3685 >> bitcast<u32>(16i)))) - _e3688) * _e3566));
let _e3697 = (2i * (_e3654 + _e3526));
let _e3699 = (_e3697 >> bitcast<u32>(2i));
let _e3702 = bitcast<u32>(((_e3697 & 3i) * 8i));
let _e3704 = select(_e2253, _e3699, (_e3699 < _e2253));
let _e3709 = global_5.member[bitcast<u32>(select(0i, _e3704, (_e3704 > 0i)))];
let _e3713 = (_e3699 + 1i);
let _e3715 = select(_e2253, _e3713, (_e3713 < _e2253));
let _e3720 = global_5.member[bitcast<u32>(select(0i, _e3715, (_e3715 > 0i)))];
let _e3727 = ((_e3709 >> bitcast<u32>((_e3702 & 31u))) | ((_e3720 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3702) & 31u))));
let _e3730 = f32(bitcast<i32>((_e3727 & 65535u)));
let _e3740 = (_e3611 + (((_e3646 + ((f32(bitcast<i32>((_e3643 >> bitcast<u32>(16i)))) - _e3646) * _e3566)) - _e3611) * _e3568));
phi_5239_ = (_e3740 + (((_e3695 + (((_e3730 + ((f32(bitcast<i32>((_e3727 >> bitcast<u32>(16i)))) - _e3730) * _e3566)) - _e3695) * _e3568)) - _e3740) * (_e3448 - f32(_e3493))));
} else {
phi_5239_ = 0f;
}
let _e3748 = phi_5239_;
let _e3749 = local;
let _e3750 = local_1[0u];
let _e3752 = local_1[1u];
let _e3754 = local_1[2u];
let _e3756 = ((_e3750 + 0f) - 0.5f);
let _e3757 = ((_e3752 + 0f) - 0.5f);
let _e3758 = ((_e3754 + 1f) - 0.5f);
let _e3760 = select(0f, _e3756, (_e3756 > 0f));
let _e3762 = select(_e2200, _e3760, (_e3760 < _e2200));
let _e3769 = select(0i, select(select(i32(_e3762), i32(-2147483648), (_e3762 < -2147483600f)), 2147483647i, (_e3762 > 2147483500f)), (_e3762 == _e3762));
let _e3773 = (_e3769 - select(0i, 1i, (_e3762 < f32(_e3769))));
let _e3775 = select(0f, _e3757, (_e3757 > 0f));
let _e3777 = select(_e2217, _e3775, (_e3775 < _e2217));
let _e3784 = select(0i, select(select(i32(_e3777), i32(-2147483648), (_e3777 < -2147483600f)), 2147483647i, (_e3777 > 2147483500f)), (_e3777 == _e3777));
let _e3788 = (_e3784 - select(0i, 1i, (_e3777 < f32(_e3784))));
let _e3790 = select(0f, _e3758, (_e3758 > 0f));
let _e3792 = select(_e2234, _e3790, (_e3790 < _e2234));
let _e3799 = select(0i, select(select(i32(_e3792), i32(-2147483648), (_e3792 < -2147483600f)), 2147483647i, (_e3792 > 2147483500f)), (_e3792 == _e3792));
let _e3803 = (_e3799 - select(0i, 1i, (_e3792 < f32(_e3799))));
let _e3804 = (_e3749 * 4i);
let _e3805 = (_e3804 + 1i);
let _e3807 = select(_e2253, _e3805, (_e3805 < _e2253));
let _e3812 = global_5.member[bitcast<u32>(select(0i, _e3807, (_e3807 > 0i)))];
let _e3813 = (_e3804 + 2i);
let _e3815 = select(_e2253, _e3813, (_e3813 < _e2253));
let _e3820 = global_5.member[bitcast<u32>(select(0i, _e3815, (_e3815 > 0i)))];
let _e3821 = (_e3804 + 3i);
let _e3823 = select(_e2253, _e3821, (_e3821 < _e2253));
let _e3828 = global_5.member[bitcast<u32>(select(0i, _e3823, (_e3823 > 0i)))];
let _e3831 = (_e3773 - bitcast<i32>((_e3812 & 65535u)));
let _e3836 = bitcast<i32>((_e3812 >> bitcast<u32>(16i)));
let _e3841 = (_e3788 - bitcast<i32>((_e3820 & 65535u)));
let _e3846 = bitcast<i32>((_e3820 >> bitcast<u32>(16i)));
let _e3851 = (_e3803 - bitcast<i32>((_e3828 & 65535u)));
if ((((_e3831 >= 0i) && ((_e3831 + 1i) < _e3836)) && ((_e3841 >= 0i) && ((_e3841 + 1i) < _e3846))) && ((_e3851 >= 0i) && ((_e3851 + 1i) < bitcast<i32>((_e3828 >> bitcast<u32>(16i)))))) {
let _e3861 = (_e3846 * _e3836);
let _e3863 = select(_e2253, _e3804, (_e3804 < _e2253));
let _e3868 = global_5.member[bitcast<u32>(select(0i, _e3863, (_e3863 > 0i)))];
let _e3874 = (((bitcast<i32>(_e3868) + (_e3851 * _e3861)) + (_e3841 * _e3836)) + _e3831);
let _e3876 = (_e3756 - f32(_e3773));
let _e3878 = (_e3757 - f32(_e3788));
let _e3881 = (2i * _e3874);
let _e3883 = (_e3881 >> bitcast<u32>(2i));
let _e3886 = bitcast<u32>(((_e3881 & 3i) * 8i));
let _e3888 = select(_e2253, _e3883, (_e3883 < _e2253));
let _e3893 = global_5.member[bitcast<u32>(select(0i, _e3888, (_e3888 > 0i)))];
let _e3897 = (_e3883 + 1i);
let _e3899 = select(_e2253, _e3897, (_e3897 < _e2253));
let _e3904 = global_5.member[bitcast<u32>(select(0i, _e3899, (_e3899 > 0i)))];
let _e3911 = ((_e3893 >> bitcast<u32>((_e3886 & 31u))) | ((_e3904 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3886) & 31u))));
let _e3914 = f32(bitcast<i32>((_e3911 & 65535u)));
let _e3921 = (_e3914 + ((f32(bitcast<i32>((_e3911 >> bitcast<u32>(16i)))) - _e3914) * _e3876));
let _e3923 = (2i * (_e3874 + _e3836));
let _e3925 = (_e3923 >> bitcast<u32>(2i));
let _e3928 = bitcast<u32>(((_e3923 & 3i) * 8i));
let _e3930 = select(_e2253, _e3925, (_e3925 < _e2253));
let _e3935 = global_5.member[bitcast<u32>(select(0i, _e3930, (_e3930 > 0i)))];
let _e3939 = (_e3925 + 1i);
let _e3941 = select(_e2253, _e3939, (_e3939 < _e2253));
let _e3946 = global_5.member[bitcast<u32>(select(0i, _e3941, (_e3941 > 0i)))];
let _e3953 = ((_e3935 >> bitcast<u32>((_e3928 & 31u))) | ((_e3946 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3928) & 31u))));
let _e3956 = f32(bitcast<i32>((_e3953 & 65535u)));
let _e3964 = (_e3874 + _e3861);
let _e3965 = (2i * _e3964);
let _e3967 = (_e3965 >> bitcast<u32>(2i));
let _e3970 = bitcast<u32>(((_e3965 & 3i) * 8i));
let _e3972 = select(_e2253, _e3967, (_e3967 < _e2253));
let _e3977 = global_5.member[bitcast<u32>(select(0i, _e3972, (_e3972 > 0i)))];
let _e3981 = (_e3967 + 1i);
let _e3983 = select(_e2253, _e3981, (_e3981 < _e2253));
let _e3988 = global_5.member[bitcast<u32>(select(0i, _e3983, (_e3983 > 0i)))];
let _e3995 = ((_e3977 >> bitcast<u32>((_e3970 & 31u))) | ((_e3988 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3970) & 31u))));
let _e3998 = f32(bitcast<i32>((_e3995 & 65535u)));
let _e4005 = (_e3998 + ((f32(bitcast<i32>((_e3995 >> bitcast<u32>(16i)))) - _e3998) * _e3876));
let _e4007 = (2i * (_e3964 + _e3836));
let _e4009 = (_e4007 >> bitcast<u32>(2i));
let _e4012 = bitcast<u32>(((_e4007 & 3i) * 8i));
let _e4014 = select(_e2253, _e4009, (_e4009 < _e2253));
let _e4019 = global_5.member[bitcast<u32>(select(0i, _e4014, (_e4014 > 0i)))];
let _e4023 = (_e4009 + 1i);
let _e4025 = select(_e2253, _e4023, (_e4023 < _e2253));
let _e4030 = global_5.member[bitcast<u32>(select(0i, _e4025, (_e4025 > 0i)))];
let _e4037 = ((_e4019 >> bitcast<u32>((_e4012 & 31u))) | ((_e4030 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4012) & 31u))));
let _e4040 = f32(bitcast<i32>((_e4037 & 65535u)));
let _e4050 = (_e3921 + (((_e3956 + ((f32(bitcast<i32>((_e3953 >> bitcast<u32>(16i)))) - _e3956) * _e3876)) - _e3921) * _e3878));
phi_5678_ = (_e4050 + (((_e4005 + (((_e4040 + ((f32(bitcast<i32>((_e4037 >> bitcast<u32>(16i)))) - _e4040) * _e3876)) - _e4005) * _e3878)) - _e4050) * (_e3758 - f32(_e3803))));
} else {
phi_5678_ = 0f;
}
let _e4058 = phi_5678_;
let _e4059 = (_e3748 - _e4058);
let _e4064 = (((_e2817 * _e2817) + (_e3438 * _e3438)) + (_e4059 * _e4059));
let _e4067 = sqrt(select(0f, _e4064, (_e4064 > 0f)));
let _e4070 = (1f / select(1e-6f, _e4067, (_e4067 > 1e-6f)));
let _e4071 = (_e2817 * _e4070);
let _e4072 = (_e3438 * _e4070);
let _e4073 = (_e4059 * _e4070);
let _e4074 = vec3<f32>(_e4071, _e4072, _e4073);
let _e4077 = local_10;
let _e4078 = (_e846.member_5 + _e4077);
let _e4081 = global_1.member.member_13;
let _e4094 = global_1.member.member_12;
let _e4098 = local_11;
let _e4100 = (((_e4078 < _e4081) && ((((_e4071 * _e846.member_4.x) + (_e4072 * _e846.member_4.y)) + (_e4073 * _e846.member_4.z)) > _e4094)) || (_e4098 == _e846.member_7));
if _e4100 {
phi_7078_ = _e846;
} else {
let _e4126 = type_20(vec3<f32>((_e846.member.x + _e1805), (_e846.member.y + _e1808), (_e846.member.z + _e1811)), _e846.member_1, _e846.member_2, _e846.member_3, _e846.member_4, _e846.member_5, _e846.member_6, _e846.member_7, _e846.member_8, _e846.member_9, _e846.member_10, _e846.member_11, _e846.member_12, _e846.member_13, _e846.member_14, _e846.member_15);
let _e4142 = type_20(_e4126.member, _e4126.member_1, _e4126.member_2, _e4126.member_3, _e4126.member_4, _e4078, _e4126.member_6, _e4126.member_7, _e4126.member_8, _e4126.member_9, _e4126.member_10, _e4126.member_11, _e4126.member_12, _e4126.member_13, _e4126.member_14, _e4126.member_15);
let _e4146 = local_12;
let _e4165 = type_20(_e4142.member, _e4142.member_1, _e4142.member_2, _e4142.member_3, _e4142.member_4, _e4142.member_5, _e4142.member_6, _e4142.member_7, _e4142.member_8, _e4142.member_9, (_e846.member_10 + select(0f, _e4146, (_e846.member_8 == 0f))), _e4142.member_11, _e4142.member_12, _e4142.member_13, _e4142.member_14, _e4142.member_15);
if (_e846.member_7 != 16i) {
let _e4169 = local_13;
let _e4186 = type_20(_e4165.member, _e4165.member_1, _e4165.member_2, _e4165.member_3, _e4165.member_4, _e4165.member_5, _e4165.member_6, _e4165.member_7, _e4165.member_8, (_e846.member_9 + _e4169), _e4165.member_10, _e4165.member_11, _e4165.member_12, _e4165.member_13, _e4165.member_14, _e4165.member_15);
let _e4187 = (_e846.member_7 * 4i);
let _e4188 = (_e4187 + 1i);
let _e4190 = (bitcast<i32>(_e97) - 1i);
let _e4192 = select(_e4190, _e4188, (_e4188 < _e4190));
let _e4198 = global_2.member[bitcast<u32>(select(0i, _e4192, (_e4192 > 0i)))];
let _e4200 = local_14;
let _e4202 = -((_e4198 * _e4200));
let _e4204 = select(-87f, _e4202, (_e4202 > -87f));
let _e4206 = select(88f, _e4204, (_e4204 < 88f));
let _e4208 = ((_e4206 * 1.442695f) + 0.5f);
let _e4210 = select(-127f, _e4208, (_e4208 > -127f));
let _e4212 = select(128f, _e4210, (_e4210 < 128f));
let _e4219 = select(0i, select(select(i32(_e4212), i32(-2147483648), (_e4212 < -2147483600f)), 2147483647i, (_e4212 > 2147483500f)), (_e4212 == _e4212));
let _e4223 = (_e4219 - select(0i, 1i, (_e4212 < f32(_e4219))));
let _e4224 = f32(_e4223);
let _e4228 = ((_e4206 - (_e4224 * 0.6933594f)) - (_e4224 * -2.1219444e-4f));
let _e4249 = (_e4187 + 2i);
let _e4251 = select(_e4190, _e4249, (_e4249 < _e4190));
let _e4257 = global_2.member[bitcast<u32>(select(0i, _e4251, (_e4251 > 0i)))];
let _e4259 = local_15;
let _e4261 = -((_e4257 * _e4259));
let _e4263 = select(-87f, _e4261, (_e4261 > -87f));
let _e4265 = select(88f, _e4263, (_e4263 < 88f));
let _e4267 = ((_e4265 * 1.442695f) + 0.5f);
let _e4269 = select(-127f, _e4267, (_e4267 > -127f));
let _e4271 = select(128f, _e4269, (_e4269 < 128f));
let _e4278 = select(0i, select(select(i32(_e4271), i32(-2147483648), (_e4271 < -2147483600f)), 2147483647i, (_e4271 > 2147483500f)), (_e4271 == _e4271));
let _e4282 = (_e4278 - select(0i, 1i, (_e4271 < f32(_e4278))));
let _e4283 = f32(_e4282);
let _e4287 = ((_e4265 - (_e4283 * 0.6933594f)) - (_e4283 * -2.1219444e-4f));
let _e4308 = (_e4187 + 3i);
let _e4310 = select(_e4190, _e4308, (_e4308 < _e4190));
let _e4316 = global_2.member[bitcast<u32>(select(0i, _e4310, (_e4310 > 0i)))];
let _e4318 = local_16;
let _e4320 = -((_e4316 * _e4318));
let _e4322 = select(-87f, _e4320, (_e4320 > -87f));
let _e4324 = select(88f, _e4322, (_e4322 < 88f));
let _e4326 = ((_e4324 * 1.442695f) + 0.5f);
let _e4328 = select(-127f, _e4326, (_e4326 > -127f));
let _e4330 = select(128f, _e4328, (_e4328 < 128f));
let _e4337 = select(0i, select(select(i32(_e4330), i32(-2147483648), (_e4330 < -2147483600f)), 2147483647i, (_e4330 > 2147483500f)), (_e4330 == _e4330));
let _e4341 = (_e4337 - select(0i, 1i, (_e4330 < f32(_e4337))));
let _e4342 = f32(_e4341);
let _e4346 = ((_e4324 - (_e4342 * 0.6933594f)) - (_e4342 * -2.1219444e-4f));
phi_6008_ = type_20(_e4186.member, _e4186.member_1, vec3<f32>((_e846.member_2.x * ((1f + (_e4228 * (1f + (_e4228 * (0.5f + (_e4228 * (0.16666667f + (_e4228 * (0.041666668f + (_e4228 * (0.008333334f + (_e4228 * (0.001388889f + (_e4228 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4223 + 127i)) << bitcast<u32>(23i))))), (_e846.member_2.y * ((1f + (_e4287 * (1f + (_e4287 * (0.5f + (_e4287 * (0.16666667f + (_e4287 * (0.041666668f + (_e4287 * (0.008333334f + (_e4287 * (0.001388889f + (_e4287 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4282 + 127i)) << bitcast<u32>(23i))))), (_e846.member_2.z * ((1f + (_e4346 * (1f + (_e4346 * (0.5f + (_e4346 * (0.16666667f + (_e4346 * (0.041666668f + (_e4346 * (0.008333334f + (_e4346 * (0.001388889f + (_e4346 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4341 + 127i)) << bitcast<u32>(23i)))))), _e4186.member_3, _e4186.member_4, _e4186.member_5, _e4186.member_6, _e4186.member_7, _e4186.member_8, _e4186.member_9, _e4186.member_10, _e4186.member_11, _e4186.member_12, _e4186.member_13, _e4186.member_14, _e4186.member_15);
} else {
phi_6008_ = _e4165;
}
let _e4394 = phi_6008_;
let _e4396 = (_e846.member_7 * 4i);
let _e4398 = (bitcast<i32>(_e97) - 1i);
let _e4400 = select(_e4398, _e4396, (_e4396 < _e4398));
let _e4406 = global_2.member[bitcast<u32>(select(0i, _e4400, (_e4400 > 0i)))];
let _e4407 = (_e846.member_7 == 16i);
let _e4408 = select(_e4406, 1f, _e4407);
let _e4410 = local_17;
let _e4411 = (_e4410 * 4i);
let _e4413 = select(_e4398, _e4411, (_e4411 < _e4398));
let _e4419 = global_2.member[bitcast<u32>(select(0i, _e4413, (_e4413 > 0i)))];
let _e4421 = local_18;
let _e4423 = select(_e4419, 1f, (_e4421 == 16i));
let _e4433 = select(1f, -1f, ((((_e4394.member_1.x * _e4071) + (_e4394.member_1.y * _e4072)) + (_e4394.member_1.z * _e4073)) > 0f));
let _e4434 = (_e4071 * _e4433);
let _e4435 = (_e4072 * _e4433);
let _e4436 = (_e4073 * _e4433);
let _e4442 = -((((_e4394.member_1.x * _e4434) + (_e4394.member_1.y * _e4435)) + (_e4394.member_1.z * _e4436)));
let _e4444 = select(0f, _e4442, (_e4442 > 0f));
let _e4445 = (_e4408 / _e4423);
let _e4447 = (_e4444 * _e4444);
let _e4450 = (1f - ((_e4445 * _e4445) * (1f - _e4447)));
let _e4451 = (_e4450 <= 0f);
let _e4459 = ((_e4445 * _e4444) - sqrt(select(0f, _e4450, (_e4450 > 0f))));
let _e4466 = (2f * _e4444);
let _e4473 = select(((_e4394.member_1.x * _e4445) + (_e4434 * _e4459)), (_e4394.member_1.x + (_e4434 * _e4466)), _e4451);
let _e4474 = select(((_e4394.member_1.y * _e4445) + (_e4435 * _e4459)), (_e4394.member_1.y + (_e4435 * _e4466)), _e4451);
let _e4475 = select(((_e4394.member_1.z * _e4445) + (_e4436 * _e4459)), (_e4394.member_1.z + (_e4436 * _e4466)), _e4451);
let _e4480 = (((_e4473 * _e4473) + (_e4474 * _e4474)) + (_e4475 * _e4475));
let _e4483 = sqrt(select(0f, _e4480, (_e4480 > 0f)));
let _e4486 = (1f / select(1e-20f, _e4483, (_e4483 > 1e-20f)));
let _e4491 = (_e4423 / _e4408);
let _e4494 = (((_e4491 * _e4491) - 1f) + _e4447);
let _e4497 = sqrt(select(0f, _e4494, (_e4494 > 0f)));
let _e4498 = (_e4497 - _e4444);
let _e4499 = (_e4497 + _e4444);
let _e4502 = (_e4498 / select(1e-6f, _e4499, (_e4499 > 1e-6f)));
let _e4506 = ((_e4444 * _e4498) + 1f);
let _e4509 = (((_e4444 * _e4499) - 1f) / select(1e-6f, _e4506, (_e4506 > 1e-6f)));
let _e4520 = (_e4394.member_8 == 0f);
let _e4523 = global_1.member.member_1;
let _e4526 = select(0f, select(select((((0.5f * _e4502) * _e4502) * (1f + (_e4509 * _e4509))), 1f, (_e4494 <= 0f)), 0f, (_e4408 == _e4423)), ((_e4523 & 1u) != 0u));
let _e4527 = (_e4520 && _e4407);
if _e4520 {
let _e4543 = type_20(_e4394.member, _e4394.member_1, _e4394.member_2, _e4074, _e4394.member_4, _e4394.member_5, _e4394.member_6, _e4394.member_7, _e4394.member_8, _e4394.member_9, _e4394.member_10, _e4394.member_11, _e4394.member_12, _e4394.member_13, _e4394.member_14, _e4394.member_15);
phi_6225_ = type_20(_e4543.member, _e4543.member_1, _e4543.member_2, _e4543.member_3, _e4543.member_4, _e4543.member_5, _e4543.member_6, _e4543.member_7, _e4543.member_8, _e4543.member_9, _e4543.member_10, select(0f, _e4526, _e4527), _e4543.member_12, _e4543.member_13, _e4543.member_14, _e4543.member_15);
} else {
phi_6225_ = _e4394;
}
let _e4562 = phi_6225_;
let _e4564 = !(_e4451);
if (!(_e4527) && _e4564) {
let _e4570 = select(_e4562.member_5, _e4562.member_9, (_e4562.member_8 == 0f));
let _e4571 = (_e4396 + 1i);
let _e4573 = select(_e4398, _e4571, (_e4571 < _e4398));
let _e4579 = global_2.member[bitcast<u32>(select(0i, _e4573, (_e4573 > 0i)))];
let _e4581 = -((_e4579 * _e4570));
let _e4583 = select(-87f, _e4581, (_e4581 > -87f));
let _e4585 = select(88f, _e4583, (_e4583 < 88f));
let _e4587 = ((_e4585 * 1.442695f) + 0.5f);
let _e4589 = select(-127f, _e4587, (_e4587 > -127f));
let _e4591 = select(128f, _e4589, (_e4589 < 128f));
let _e4598 = select(0i, select(select(i32(_e4591), i32(-2147483648), (_e4591 < -2147483600f)), 2147483647i, (_e4591 > 2147483500f)), (_e4591 == _e4591));
let _e4602 = (_e4598 - select(0i, 1i, (_e4591 < f32(_e4598))));
let _e4603 = f32(_e4602);
let _e4607 = ((_e4585 - (_e4603 * 0.6933594f)) - (_e4603 * -2.1219444e-4f));
let _e4628 = (_e4396 + 2i);
let _e4630 = select(_e4398, _e4628, (_e4628 < _e4398));
let _e4636 = global_2.member[bitcast<u32>(select(0i, _e4630, (_e4630 > 0i)))];
let _e4638 = -((_e4636 * _e4570));
let _e4640 = select(-87f, _e4638, (_e4638 > -87f));
let _e4642 = select(88f, _e4640, (_e4640 < 88f));
let _e4644 = ((_e4642 * 1.442695f) + 0.5f);
let _e4646 = select(-127f, _e4644, (_e4644 > -127f));
let _e4648 = select(128f, _e4646, (_e4646 < 128f));
let _e4655 = select(0i, select(select(i32(_e4648), i32(-2147483648), (_e4648 < -2147483600f)), 2147483647i, (_e4648 > 2147483500f)), (_e4648 == _e4648));
let _e4659 = (_e4655 - select(0i, 1i, (_e4648 < f32(_e4655))));
let _e4660 = f32(_e4659);
let _e4664 = ((_e4642 - (_e4660 * 0.6933594f)) - (_e4660 * -2.1219444e-4f));
let _e4685 = (_e4396 + 3i);
let _e4687 = select(_e4398, _e4685, (_e4685 < _e4398));
let _e4693 = global_2.member[bitcast<u32>(select(0i, _e4687, (_e4687 > 0i)))];
let _e4695 = -((_e4693 * _e4570));
let _e4697 = select(-87f, _e4695, (_e4695 > -87f));
let _e4699 = select(88f, _e4697, (_e4697 < 88f));
let _e4701 = ((_e4699 * 1.442695f) + 0.5f);
let _e4703 = select(-127f, _e4701, (_e4701 > -127f));
let _e4705 = select(128f, _e4703, (_e4703 < 128f));
let _e4712 = select(0i, select(select(i32(_e4705), i32(-2147483648), (_e4705 < -2147483600f)), 2147483647i, (_e4705 > 2147483500f)), (_e4705 == _e4705));
let _e4716 = (_e4712 - select(0i, 1i, (_e4705 < f32(_e4712))));
let _e4717 = f32(_e4716);
let _e4721 = ((_e4699 - (_e4717 * 0.6933594f)) - (_e4717 * -2.1219444e-4f));
let _e4743 = select(((1f + (_e4607 * (1f + (_e4607 * (0.5f + (_e4607 * (0.16666667f + (_e4607 * (0.041666668f + (_e4607 * (0.008333334f + (_e4607 * (0.001388889f + (_e4607 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4602 + 127i)) << bitcast<u32>(23i)))), 1f, _e4407);
let _e4745 = (1f - (_e4526 * _e4743));
let _e4747 = (1f - _e4526);
let _e4753 = select(((1f + (_e4664 * (1f + (_e4664 * (0.5f + (_e4664 * (0.16666667f + (_e4664 * (0.041666668f + (_e4664 * (0.008333334f + (_e4664 * (0.001388889f + (_e4664 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4659 + 127i)) << bitcast<u32>(23i)))), 1f, _e4407);
let _e4755 = (1f - (_e4526 * _e4753));
let _e4762 = select(((1f + (_e4721 * (1f + (_e4721 * (0.5f + (_e4721 * (0.16666667f + (_e4721 * (0.041666668f + (_e4721 * (0.008333334f + (_e4721 * (0.001388889f + (_e4721 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4716 + 127i)) << bitcast<u32>(23i)))), 1f, _e4407);
let _e4764 = (1f - (_e4526 * _e4762));
phi_6556_ = type_20(_e4562.member, _e4562.member_1, _e4562.member_2, _e4562.member_3, _e4562.member_4, _e4562.member_5, _e4562.member_6, _e4562.member_7, _e4562.member_8, _e4562.member_9, _e4562.member_10, _e4562.member_11, vec3<f32>((_e4562.member_12.x + ((_e4562.member_2.x * select(1f, ((_e4747 * _e4743) / select(1e-9f, _e4745, (_e4745 > 1e-9f))), (_e4745 > 0f))) * _e4526)), (_e4562.member_12.y + ((_e4562.member_2.y * select(1f, ((_e4747 * _e4753) / select(1e-9f, _e4755, (_e4755 > 1e-9f))), (_e4755 > 0f))) * _e4526)), (_e4562.member_12.z + ((_e4562.member_2.z * select(1f, ((_e4747 * _e4762) / select(1e-9f, _e4764, (_e4764 > 1e-9f))), (_e4764 > 0f))) * _e4526))), _e4562.member_13, _e4562.member_14, _e4562.member_15);
} else {
phi_6556_ = _e4562;
}
let _e4807 = phi_6556_;
let _e4809 = (_e4807.member_8 + 1f);
let _e4825 = type_20(_e4807.member, _e4807.member_1, _e4807.member_2, _e4807.member_3, _e4807.member_4, _e4807.member_5, _e4807.member_6, _e4807.member_7, _e4809, _e4807.member_9, _e4807.member_10, _e4807.member_11, _e4807.member_12, _e4807.member_13, _e4807.member_14, _e4807.member_15);
let _e4828 = ((_e104.member_2 == 0u) && (_e4809 >= 2f));
if (_e4451 && _e4828) {
let _e4854 = (((_e4807.member_1.x * _e4071) + (_e4807.member_1.y * _e4072)) + (_e4807.member_1.z * _e4073));
let _e4858 = (_e4807.member_1.x - (_e4071 * _e4854));
let _e4859 = (_e4807.member_1.y - (_e4072 * _e4854));
let _e4860 = (_e4807.member_1.z - (_e4073 * _e4854));
let _e4865 = (((_e4858 * _e4858) + (_e4859 * _e4859)) + (_e4860 * _e4860));
let _e4868 = sqrt(select(0f, _e4865, (_e4865 > 0f)));
let _e4871 = (1f / select(1e-20f, _e4868, (_e4868 > 1e-20f)));
phi_6609_ = type_20(_e4825.member, vec3<f32>((_e4858 * _e4871), (_e4859 * _e4871), (_e4860 * _e4871)), _e4825.member_2, _e4825.member_3, _e4825.member_4, _e4825.member_5, _e4825.member_6, _e4825.member_7, _e4825.member_8, _e4825.member_9, _e4825.member_10, _e4825.member_11, _e4825.member_12, _e4825.member_13, _e4825.member_14, _e4825.member_15);
} else {
phi_6609_ = type_20(_e4825.member, vec3<f32>((_e4473 * _e4486), (_e4474 * _e4486), (_e4475 * _e4486)), _e4825.member_2, _e4825.member_3, _e4825.member_4, _e4825.member_5, _e4825.member_6, _e4825.member_7, _e4825.member_8, _e4825.member_9, _e4825.member_10, _e4825.member_11, _e4825.member_12, _e4825.member_13, _e4825.member_14, _e4825.member_15);
}
let _e4893 = phi_6609_;
if _e4451 {
phi_6623_ = _e4893;
} else {
let _e4894 = (1f - _e4526);
phi_6623_ = type_20(_e4893.member, _e4893.member_1, vec3<f32>((_e4893.member_2.x * _e4894), (_e4893.member_2.y * _e4894), (_e4893.member_2.z * _e4894)), _e4893.member_3, _e4893.member_4, _e4893.member_5, _e4893.member_6, _e4893.member_7, _e4893.member_8, _e4893.member_9, _e4893.member_10, _e4893.member_11, _e4893.member_12, _e4893.member_13, _e4893.member_14, _e4893.member_15);
}
let _e4922 = phi_6623_;
let _e4938 = type_20(_e4922.member, _e4922.member_1, _e4922.member_2, _e4922.member_3, _e4922.member_4, 0f, _e4922.member_6, _e4922.member_7, _e4922.member_8, _e4922.member_9, _e4922.member_10, _e4922.member_11, _e4922.member_12, _e4922.member_13, _e4922.member_14, _e4922.member_15);
let _e4945 = global_1.member.member_18.member.member;
let _e4959 = ((((_e4945.member.member * _e4922.member.x) + (_e4945.member.member_1 * _e4922.member.y)) + (_e4945.member.member_2 * _e4922.member.z)) + _e4945.member_1);
let _e4968 = -((((_e4945.member.member * _e4922.member_1.x) + (_e4945.member.member_1 * _e4922.member_1.y)) + (_e4945.member.member_2 * _e4922.member_1.z)));
let _e4970 = (_e4968 > 1e-9f);
let _e4974 = ((_e4959 / select(1e-9f, _e4968, _e4970)) - 0.015625f);
let _e4977 = select(1e30f, select(0f, _e4974, (_e4974 > 0f)), ((_e4959 > 0f) && _e4970));
let _e4982 = global_1.member.member_18.member_1.member;
let _e4993 = ((((_e4982.member.member * _e4922.member.x) + (_e4982.member.member_1 * _e4922.member.y)) + (_e4982.member.member_2 * _e4922.member.z)) + _e4982.member_1);
let _e4999 = -((((_e4982.member.member * _e4922.member_1.x) + (_e4982.member.member_1 * _e4922.member_1.y)) + (_e4982.member.member_2 * _e4922.member_1.z)));
let _e5001 = (_e4999 > 1e-9f);
let _e5005 = ((_e4993 / select(1e-9f, _e4999, _e5001)) - 0.015625f);
let _e5008 = select(1e30f, select(0f, _e5005, (_e5005 > 0f)), ((_e4993 > 0f) && _e5001));
let _e5012 = (_e5008 < _e4977);
let _e5014 = select(select(-2i, -3i, _e5012), -1i, ((_e4977 >= 1e30f) && (_e5008 >= 1e30f)));
let _e5015 = select(_e4977, _e5008, _e5012);
let _e5031 = type_20(_e4938.member, _e4938.member_1, _e4938.member_2, _e4938.member_3, _e4938.member_4, _e4938.member_5, _e4938.member_6, _e4938.member_7, _e4938.member_8, _e4938.member_9, _e4938.member_10, _e4938.member_11, _e4938.member_12, 0i, _e4938.member_14, _e4938.member_15);
let _e5047 = type_20(_e5031.member, _e5031.member_1, _e5031.member_2, _e5031.member_3, _e5031.member_4, _e5031.member_5, _e5031.member_6, _e5031.member_7, _e5031.member_8, _e5031.member_9, _e5031.member_10, _e5031.member_11, _e5031.member_12, _e5031.member_13, _e5014, _e5031.member_15);
let _e5063 = type_20(_e5047.member, _e5047.member_1, _e5047.member_2, _e5047.member_3, _e5047.member_4, _e5047.member_5, _e5047.member_6, _e5047.member_7, _e5047.member_8, _e5047.member_9, _e5047.member_10, _e5047.member_11, _e5047.member_12, _e5047.member_13, _e5047.member_14, _e5015);
let _e5065 = local_19;
let _e5068 = ((_e4523 & 2u) != 0u);
if (_e4828 && !(_e5068)) {
if (_e5014 == -1i) {
phi_7049_ = type_20(_e5063.member, _e5063.member_1, _e5063.member_2, _e5063.member_3, _e5063.member_4, _e5063.member_5, 1f, _e5063.member_7, _e5063.member_8, _e5063.member_9, _e5063.member_10, _e5063.member_11, _e5063.member_12, _e5063.member_13, _e5063.member_14, _e5063.member_15);
} else {
let _e5147 = type_20(vec3<f32>((_e4922.member.x + (_e4922.member_1.x * _e5015)), (_e4922.member.y + (_e4922.member_1.y * _e5015)), (_e4922.member.z + (_e4922.member_1.z * _e5015))), _e5063.member_1, _e5063.member_2, _e5063.member_3, _e5063.member_4, _e5063.member_5, _e5063.member_6, _e5063.member_7, _e5063.member_8, _e5063.member_9, _e5063.member_10, _e5063.member_11, _e5063.member_12, _e5063.member_13, _e5063.member_14, _e5063.member_15);
let _e5164 = type_20(_e5147.member, _e5147.member_1, _e5147.member_2, _e5147.member_3, _e5147.member_4, (0f + _e5015), _e5147.member_6, _e5147.member_7, _e5147.member_8, _e5147.member_9, _e5147.member_10, _e5147.member_11, _e5147.member_12, _e5147.member_13, _e5147.member_14, _e5147.member_15);
let _e5181 = type_20(_e5164.member, _e5164.member_1, _e5164.member_2, _e5164.member_3, _e5164.member_4, _e5164.member_5, _e5164.member_6, _e5164.member_7, _e5164.member_8, _e5164.member_9, _e5164.member_10, _e5164.member_11, _e5164.member_12, _e5164.member_13, _e5164.member_14, (_e5015 - _e5015));
let _e5202 = type_20(_e5181.member, _e5181.member_1, _e5181.member_2, _e5181.member_3, _e5181.member_4, _e5181.member_5, _e5181.member_6, _e5181.member_7, _e5181.member_8, _e5181.member_9, (_e4922.member_10 + select(0f, _e5015, (_e4922.member_8 == 0f))), _e5181.member_11, _e5181.member_12, _e5181.member_13, _e5181.member_14, _e5181.member_15);
phi_7049_ = type_20(_e5202.member, _e5202.member_1, _e5202.member_2, _e5202.member_3, _e5202.member_4, _e5202.member_5, 3f, _e5202.member_7, _e5202.member_8, _e5202.member_9, _e5202.member_10, _e5202.member_11, _e5202.member_12, _e5202.member_13, _e5202.member_14, _e5202.member_15);
}
let _e5236 = phi_7049_;
phi_7070_ = _e5236;
} else {
let _e5075 = global_1.member.member_5;
if ((!(_e4828) && (_e4922.member_8 >= f32(bitcast<i32>(_e5075)))) && (select(_e5065, _e846.member_7, _e4451) != 16i)) {
phi_7069_ = type_20(_e5063.member, _e5063.member_1, _e5063.member_2, _e5063.member_3, _e5063.member_4, _e5063.member_5, 2f, _e5063.member_7, _e5063.member_8, _e5063.member_9, _e5063.member_10, _e5063.member_11, _e5063.member_12, _e5063.member_13, _e5063.member_14, _e5063.member_15);
} else {
if _e5068 {
phi_7068_ = type_20(_e5063.member, _e5063.member_1, _e5063.member_2, _e5063.member_3, _e5063.member_4, _e5063.member_5, 4f, _e5063.member_7, _e5063.member_8, _e5063.member_9, _e5063.member_10, _e5063.member_11, _e5063.member_12, _e5063.member_13, _e5063.member_14, _e5063.member_15);
} else {
phi_7068_ = _e5063;
}
let _e5099 = phi_7068_;
phi_7069_ = _e5099;
}
let _e5117 = phi_7069_;
phi_7070_ = _e5117;
}
let _e5238 = phi_7070_;
let _e5240 = local_20;
let _e5257 = type_20(_e5238.member, _e5238.member_1, _e5238.member_2, _e5238.member_3, _e5238.member_4, _e5238.member_5, _e5238.member_6, select(_e846.member_7, _e5240, _e4564), _e5238.member_8, _e5238.member_9, _e5238.member_10, _e5238.member_11, _e5238.member_12, _e5238.member_13, _e5238.member_14, _e5238.member_15);
phi_7078_ = type_20(_e5257.member, _e5257.member_1, _e5257.member_2, _e5257.member_3, _e4074, _e5257.member_5, _e5257.member_6, _e5257.member_7, _e5257.member_8, _e5257.member_9, _e5257.member_10, _e5257.member_11, _e5257.member_12, _e5257.member_13, _e5257.member_14, _e5257.member_15);
}
let _e5275 = phi_7078_;
phi_7079_ = _e5275;
phi_7080_ = _e4100;
}
let _e5277 = phi_7079_;
let _e5279 = phi_7080_;
if (_e5279 && _e1056) {
let _e5762 = type_20(vec3<f32>((_e5277.member.x + (_e5277.member_1.x * _e5277.member_15)), (_e5277.member.y + (_e5277.member_1.y * _e5277.member_15)), (_e5277.member.z + (_e5277.member_1.z * _e5277.member_15))), _e5277.member_1, _e5277.member_2, _e5277.member_3, _e5277.member_4, _e5277.member_5, _e5277.member_6, _e5277.member_7, _e5277.member_8, _e5277.member_9, _e5277.member_10, _e5277.member_11, _e5277.member_12, _e5277.member_13, _e5277.member_14, _e5277.member_15);
let _e5780 = type_20(_e5762.member, _e5762.member_1, _e5762.member_2, _e5762.member_3, _e5762.member_4, (_e5277.member_5 + _e5277.member_15), _e5762.member_6, _e5762.member_7, _e5762.member_8, _e5762.member_9, _e5762.member_10, _e5762.member_11, _e5762.member_12, _e5762.member_13, _e5762.member_14, _e5762.member_15);
let _e5797 = type_20(_e5780.member, _e5780.member_1, _e5780.member_2, _e5780.member_3, _e5780.member_4, _e5780.member_5, _e5780.member_6, _e5780.member_7, _e5780.member_8, _e5780.member_9, _e5780.member_10, _e5780.member_11, _e5780.member_12, _e5780.member_13, _e5780.member_14, (_e5277.member_15 - _e5277.member_15));
let _e5818 = type_20(_e5797.member, _e5797.member_1, _e5797.member_2, _e5797.member_3, _e5797.member_4, _e5797.member_5, _e5797.member_6, _e5797.member_7, _e5797.member_8, _e5797.member_9, (_e5277.member_10 + select(0f, _e5277.member_15, (_e5277.member_8 == 0f))), _e5797.member_11, _e5797.member_12, _e5797.member_13, _e5797.member_14, _e5797.member_15);
if (_e846.member_7 != 16i) {
let _e5837 = type_20(_e5818.member, _e5818.member_1, _e5818.member_2, _e5818.member_3, _e5818.member_4, _e5818.member_5, _e5818.member_6, _e5818.member_7, _e5818.member_8, (_e5277.member_9 + _e5277.member_15), _e5818.member_10, _e5818.member_11, _e5818.member_12, _e5818.member_13, _e5818.member_14, _e5818.member_15);
let _e5838 = (_e846.member_7 * 4i);
let _e5839 = (_e5838 + 1i);
let _e5841 = (bitcast<i32>(_e97) - 1i);
let _e5843 = select(_e5841, _e5839, (_e5839 < _e5841));
let _e5849 = global_2.member[bitcast<u32>(select(0i, _e5843, (_e5843 > 0i)))];
let _e5851 = -((_e5849 * _e5277.member_15));
let _e5853 = select(-87f, _e5851, (_e5851 > -87f));
let _e5855 = select(88f, _e5853, (_e5853 < 88f));
let _e5857 = ((_e5855 * 1.442695f) + 0.5f);
let _e5859 = select(-127f, _e5857, (_e5857 > -127f));
let _e5861 = select(128f, _e5859, (_e5859 < 128f));
let _e5868 = select(0i, select(select(i32(_e5861), i32(-2147483648), (_e5861 < -2147483600f)), 2147483647i, (_e5861 > 2147483500f)), (_e5861 == _e5861));
let _e5872 = (_e5868 - select(0i, 1i, (_e5861 < f32(_e5868))));
let _e5873 = f32(_e5872);
let _e5877 = ((_e5855 - (_e5873 * 0.6933594f)) - (_e5873 * -2.1219444e-4f));
let _e5898 = (_e5838 + 2i);
let _e5900 = select(_e5841, _e5898, (_e5898 < _e5841));
let _e5906 = global_2.member[bitcast<u32>(select(0i, _e5900, (_e5900 > 0i)))];
let _e5908 = -((_e5906 * _e5277.member_15));
let _e5910 = select(-87f, _e5908, (_e5908 > -87f));
let _e5912 = select(88f, _e5910, (_e5910 < 88f));
let _e5914 = ((_e5912 * 1.442695f) + 0.5f);
let _e5916 = select(-127f, _e5914, (_e5914 > -127f));
let _e5918 = select(128f, _e5916, (_e5916 < 128f));
let _e5925 = select(0i, select(select(i32(_e5918), i32(-2147483648), (_e5918 < -2147483600f)), 2147483647i, (_e5918 > 2147483500f)), (_e5918 == _e5918));
let _e5929 = (_e5925 - select(0i, 1i, (_e5918 < f32(_e5925))));
let _e5930 = f32(_e5929);
let _e5934 = ((_e5912 - (_e5930 * 0.6933594f)) - (_e5930 * -2.1219444e-4f));
let _e5955 = (_e5838 + 3i);
let _e5957 = select(_e5841, _e5955, (_e5955 < _e5841));
let _e5963 = global_2.member[bitcast<u32>(select(0i, _e5957, (_e5957 > 0i)))];
let _e5965 = -((_e5963 * _e5277.member_15));
let _e5967 = select(-87f, _e5965, (_e5965 > -87f));
let _e5969 = select(88f, _e5967, (_e5967 < 88f));
let _e5971 = ((_e5969 * 1.442695f) + 0.5f);
let _e5973 = select(-127f, _e5971, (_e5971 > -127f));
let _e5975 = select(128f, _e5973, (_e5973 < 128f));
let _e5982 = select(0i, select(select(i32(_e5975), i32(-2147483648), (_e5975 < -2147483600f)), 2147483647i, (_e5975 > 2147483500f)), (_e5975 == _e5975));
let _e5986 = (_e5982 - select(0i, 1i, (_e5975 < f32(_e5982))));
let _e5987 = f32(_e5986);
let _e5991 = ((_e5969 - (_e5987 * 0.6933594f)) - (_e5987 * -2.1219444e-4f));
phi_7370_ = type_20(_e5837.member, _e5837.member_1, vec3<f32>((_e5277.member_2.x * ((1f + (_e5877 * (1f + (_e5877 * (0.5f + (_e5877 * (0.16666667f + (_e5877 * (0.041666668f + (_e5877 * (0.008333334f + (_e5877 * (0.001388889f + (_e5877 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5872 + 127i)) << bitcast<u32>(23i))))), (_e5277.member_2.y * ((1f + (_e5934 * (1f + (_e5934 * (0.5f + (_e5934 * (0.16666667f + (_e5934 * (0.041666668f + (_e5934 * (0.008333334f + (_e5934 * (0.001388889f + (_e5934 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5929 + 127i)) << bitcast<u32>(23i))))), (_e5277.member_2.z * ((1f + (_e5991 * (1f + (_e5991 * (0.5f + (_e5991 * (0.16666667f + (_e5991 * (0.041666668f + (_e5991 * (0.008333334f + (_e5991 * (0.001388889f + (_e5991 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5986 + 127i)) << bitcast<u32>(23i)))))), _e5837.member_3, _e5837.member_4, _e5837.member_5, _e5837.member_6, _e5837.member_7, _e5837.member_8, _e5837.member_9, _e5837.member_10, _e5837.member_11, _e5837.member_12, _e5837.member_13, _e5837.member_14, _e5837.member_15);
} else {
phi_7370_ = _e5818;
}
let _e6039 = phi_7370_;
phi_7964_ = type_20(_e6039.member, _e6039.member_1, _e6039.member_2, _e6039.member_3, _e6039.member_4, _e6039.member_5, 3f, _e6039.member_7, _e6039.member_8, _e6039.member_9, _e6039.member_10, _e6039.member_11, _e6039.member_12, _e6039.member_13, _e6039.member_14, _e6039.member_15);
} else {
if _e5279 {
let _e5313 = type_20(vec3<f32>((_e5277.member.x + (_e5277.member_1.x * _e1057)), (_e5277.member.y + (_e5277.member_1.y * _e1057)), (_e5277.member.z + (_e5277.member_1.z * _e1057))), _e5277.member_1, _e5277.member_2, _e5277.member_3, _e5277.member_4, _e5277.member_5, _e5277.member_6, _e5277.member_7, _e5277.member_8, _e5277.member_9, _e5277.member_10, _e5277.member_11, _e5277.member_12, _e5277.member_13, _e5277.member_14, _e5277.member_15);
let _e5331 = type_20(_e5313.member, _e5313.member_1, _e5313.member_2, _e5313.member_3, _e5313.member_4, (_e5277.member_5 + _e1057), _e5313.member_6, _e5313.member_7, _e5313.member_8, _e5313.member_9, _e5313.member_10, _e5313.member_11, _e5313.member_12, _e5313.member_13, _e5313.member_14, _e5313.member_15);
let _e5349 = type_20(_e5331.member, _e5331.member_1, _e5331.member_2, _e5331.member_3, _e5331.member_4, _e5331.member_5, _e5331.member_6, _e5331.member_7, _e5331.member_8, _e5331.member_9, _e5331.member_10, _e5331.member_11, _e5331.member_12, _e5331.member_13, _e5331.member_14, (_e5277.member_15 - _e1057));
let _e5370 = type_20(_e5349.member, _e5349.member_1, _e5349.member_2, _e5349.member_3, _e5349.member_4, _e5349.member_5, _e5349.member_6, _e5349.member_7, _e5349.member_8, _e5349.member_9, (_e5277.member_10 + select(0f, _e1057, (_e5277.member_8 == 0f))), _e5349.member_11, _e5349.member_12, _e5349.member_13, _e5349.member_14, _e5349.member_15);
if (_e846.member_7 != 16i) {
let _e5389 = type_20(_e5370.member, _e5370.member_1, _e5370.member_2, _e5370.member_3, _e5370.member_4, _e5370.member_5, _e5370.member_6, _e5370.member_7, _e5370.member_8, (_e5277.member_9 + _e1057), _e5370.member_10, _e5370.member_11, _e5370.member_12, _e5370.member_13, _e5370.member_14, _e5370.member_15);
let _e5390 = (_e846.member_7 * 4i);
let _e5391 = (_e5390 + 1i);
let _e5393 = (bitcast<i32>(_e97) - 1i);
let _e5395 = select(_e5393, _e5391, (_e5391 < _e5393));
let _e5401 = global_2.member[bitcast<u32>(select(0i, _e5395, (_e5395 > 0i)))];
let _e5403 = -((_e5401 * _e1057));
let _e5405 = select(-87f, _e5403, (_e5403 > -87f));
let _e5407 = select(88f, _e5405, (_e5405 < 88f));
let _e5409 = ((_e5407 * 1.442695f) + 0.5f);
let _e5411 = select(-127f, _e5409, (_e5409 > -127f));
let _e5413 = select(128f, _e5411, (_e5411 < 128f));
let _e5420 = select(0i, select(select(i32(_e5413), i32(-2147483648), (_e5413 < -2147483600f)), 2147483647i, (_e5413 > 2147483500f)), (_e5413 == _e5413));
let _e5424 = (_e5420 - select(0i, 1i, (_e5413 < f32(_e5420))));
let _e5425 = f32(_e5424);
let _e5429 = ((_e5407 - (_e5425 * 0.6933594f)) - (_e5425 * -2.1219444e-4f));
let _e5450 = (_e5390 + 2i);
let _e5452 = select(_e5393, _e5450, (_e5450 < _e5393));
let _e5458 = global_2.member[bitcast<u32>(select(0i, _e5452, (_e5452 > 0i)))];
let _e5460 = -((_e5458 * _e1057));
let _e5462 = select(-87f, _e5460, (_e5460 > -87f));
let _e5464 = select(88f, _e5462, (_e5462 < 88f));
let _e5466 = ((_e5464 * 1.442695f) + 0.5f);
let _e5468 = select(-127f, _e5466, (_e5466 > -127f));
let _e5470 = select(128f, _e5468, (_e5468 < 128f));
let _e5477 = select(0i, select(select(i32(_e5470), i32(-2147483648), (_e5470 < -2147483600f)), 2147483647i, (_e5470 > 2147483500f)), (_e5470 == _e5470));
let _e5481 = (_e5477 - select(0i, 1i, (_e5470 < f32(_e5477))));
let _e5482 = f32(_e5481);
let _e5486 = ((_e5464 - (_e5482 * 0.6933594f)) - (_e5482 * -2.1219444e-4f));
let _e5507 = (_e5390 + 3i);
let _e5509 = select(_e5393, _e5507, (_e5507 < _e5393));
let _e5515 = global_2.member[bitcast<u32>(select(0i, _e5509, (_e5509 > 0i)))];
let _e5517 = -((_e5515 * _e1057));
let _e5519 = select(-87f, _e5517, (_e5517 > -87f));
let _e5521 = select(88f, _e5519, (_e5519 < 88f));
let _e5523 = ((_e5521 * 1.442695f) + 0.5f);
let _e5525 = select(-127f, _e5523, (_e5523 > -127f));
let _e5527 = select(128f, _e5525, (_e5525 < 128f));
let _e5534 = select(0i, select(select(i32(_e5527), i32(-2147483648), (_e5527 < -2147483600f)), 2147483647i, (_e5527 > 2147483500f)), (_e5527 == _e5527));
let _e5538 = (_e5534 - select(0i, 1i, (_e5527 < f32(_e5534))));
let _e5539 = f32(_e5538);
let _e5543 = ((_e5521 - (_e5539 * 0.6933594f)) - (_e5539 * -2.1219444e-4f));
phi_7659_ = type_20(_e5389.member, _e5389.member_1, vec3<f32>((_e5277.member_2.x * ((1f + (_e5429 * (1f + (_e5429 * (0.5f + (_e5429 * (0.16666667f + (_e5429 * (0.041666668f + (_e5429 * (0.008333334f + (_e5429 * (0.001388889f + (_e5429 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5424 + 127i)) << bitcast<u32>(23i))))), (_e5277.member_2.y * ((1f + (_e5486 * (1f + (_e5486 * (0.5f + (_e5486 * (0.16666667f + (_e5486 * (0.041666668f + (_e5486 * (0.008333334f + (_e5486 * (0.001388889f + (_e5486 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5481 + 127i)) << bitcast<u32>(23i))))), (_e5277.member_2.z * ((1f + (_e5543 * (1f + (_e5543 * (0.5f + (_e5543 * (0.16666667f + (_e5543 * (0.041666668f + (_e5543 * (0.008333334f + (_e5543 * (0.001388889f + (_e5543 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5538 + 127i)) << bitcast<u32>(23i)))))), _e5389.member_3, _e5389.member_4, _e5389.member_5, _e5389.member_6, _e5389.member_7, _e5389.member_8, _e5389.member_9, _e5389.member_10, _e5389.member_11, _e5389.member_12, _e5389.member_13, _e5389.member_14, _e5389.member_15);
} else {
phi_7659_ = _e5370;
}
let _e5591 = phi_7659_;
let _e5594 = local_21;
if (((_e907 <= 0f) && (_e5594 == 16i)) && (_e846.member_7 == 16i)) {
if (_e5591.member_14 == -1i) {
phi_7961_ = type_20(_e5591.member, _e5591.member_1, _e5591.member_2, _e5591.member_3, _e5591.member_4, _e5591.member_5, 1f, _e5591.member_7, _e5591.member_8, _e5591.member_9, _e5591.member_10, _e5591.member_11, _e5591.member_12, _e5591.member_13, _e5591.member_14, _e5591.member_15);
} else {
let _e5634 = type_20(vec3<f32>((_e5591.member.x + (_e5591.member_1.x * _e5591.member_15)), (_e5591.member.y + (_e5591.member_1.y * _e5591.member_15)), (_e5591.member.z + (_e5591.member_1.z * _e5591.member_15))), _e5591.member_1, _e5591.member_2, _e5591.member_3, _e5591.member_4, _e5591.member_5, _e5591.member_6, _e5591.member_7, _e5591.member_8, _e5591.member_9, _e5591.member_10, _e5591.member_11, _e5591.member_12, _e5591.member_13, _e5591.member_14, _e5591.member_15);
let _e5652 = type_20(_e5634.member, _e5634.member_1, _e5634.member_2, _e5634.member_3, _e5634.member_4, (_e5591.member_5 + _e5591.member_15), _e5634.member_6, _e5634.member_7, _e5634.member_8, _e5634.member_9, _e5634.member_10, _e5634.member_11, _e5634.member_12, _e5634.member_13, _e5634.member_14, _e5634.member_15);
let _e5669 = type_20(_e5652.member, _e5652.member_1, _e5652.member_2, _e5652.member_3, _e5652.member_4, _e5652.member_5, _e5652.member_6, _e5652.member_7, _e5652.member_8, _e5652.member_9, _e5652.member_10, _e5652.member_11, _e5652.member_12, _e5652.member_13, _e5652.member_14, (_e5591.member_15 - _e5591.member_15));
let _e5690 = type_20(_e5669.member, _e5669.member_1, _e5669.member_2, _e5669.member_3, _e5669.member_4, _e5669.member_5, _e5669.member_6, _e5669.member_7, _e5669.member_8, _e5669.member_9, (_e5591.member_10 + select(0f, _e5591.member_15, (_e5591.member_8 == 0f))), _e5669.member_11, _e5669.member_12, _e5669.member_13, _e5669.member_14, _e5669.member_15);
phi_7961_ = type_20(_e5690.member, _e5690.member_1, _e5690.member_2, _e5690.member_3, _e5690.member_4, _e5690.member_5, 3f, _e5690.member_7, _e5690.member_8, _e5690.member_9, _e5690.member_10, _e5690.member_11, _e5690.member_12, _e5690.member_13, _e5690.member_14, _e5690.member_15);
}
let _e5724 = phi_7961_;
phi_7962_ = _e5724;
} else {
phi_7962_ = _e5591;
}
let _e5726 = phi_7962_;
phi_7963_ = _e5726;
} else {
phi_7963_ = _e5277;
}
let _e5728 = phi_7963_;
phi_7964_ = _e5728;
}
let _e6057 = phi_7964_;
phi_1247_ = _e6057;
phi_1250_ = (_e848 + 1i);
} else {
phi_1247_ = type_20();
phi_1250_ = i32();
}
let _e6059 = phi_1247_;
let _e6061 = phi_1250_;
continue;
continuing {
phi_1246_ = _e6059;
phi_1249_ = _e6061;
break if !(_e852);
}
}
let _e6064 = local_22;
let _e6068 = local_23;
let _e6072 = local_24;
let _e6076 = local_25;
let _e6080 = local_26;
let _e6084 = local_27;
let _e6088 = local_28;
let _e6092 = local_29;
let _e6096 = local_30;
let _e6100 = local_31;
let _e6104 = local_32;
let _e6108 = local_33;
let _e6112 = local_34;
let _e6116 = local_35;
let _e6120 = local_36;
let _e6124 = local_37;
let _e6127 = local_38;
let _e6131 = local_39;
let _e6134 = local_40;
let _e6137 = local_41;
let _e6140 = local_42;
let _e6143 = local_43;
let _e6147 = local_44;
let _e6151 = local_45;
let _e6155 = local_46;
let _e6159 = local_47;
let _e6163 = local_48;
global_3.member[_e113] = _e6064.member.x;
global_3.member[_e125] = _e6068.member.y;
global_3.member[_e136] = _e6072.member.z;
global_3.member[_e147] = _e6076.member_1.x;
global_3.member[_e158] = _e6080.member_1.y;
global_3.member[_e169] = _e6084.member_1.z;
global_3.member[_e180] = _e6088.member_2.x;
global_3.member[_e191] = _e6092.member_2.y;
global_3.member[_e202] = _e6096.member_2.z;
global_3.member[_e213] = _e6100.member_3.x;
global_3.member[_e224] = _e6104.member_3.y;
global_3.member[_e235] = _e6108.member_3.z;
global_3.member[_e246] = _e6112.member_4.x;
global_3.member[_e257] = _e6116.member_4.y;
global_3.member[_e268] = _e6120.member_4.z;
global_3.member[_e279] = _e6124.member_5;
let _e6200 = local_49;
global_3.member[_e290] = _e6200;
global_3.member[_e301] = f32(_e6127.member_7);
global_3.member[_e312] = _e6131.member_8;
global_3.member[_e323] = _e6134.member_9;
global_3.member[_e334] = _e6137.member_10;
global_3.member[_e345] = _e6140.member_11;
global_3.member[_e356] = _e6143.member_12.x;
global_3.member[_e367] = _e6147.member_12.y;
global_3.member[_e378] = _e6151.member_12.z;
global_3.member[_e389] = f32(_e6155.member_13);
global_3.member[_e400] = f32(_e6159.member_14);
global_3.member[_e411] = _e6163.member_15;
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
