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
struct type_11 {
member: array<f32>,
}
struct type_15 {
member: array<u32>,
}
struct type_16 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_17 {
member: u32,
member_1: u32,
}
struct type_18 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_19 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_20 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_21 {
member: type_5,
member_1: type_5,
}
struct type_22 {
member: type_7,
member_1: u32,
}
struct type_23 {
member: type_2,
member_1: u32,
member_2: type_16,
member_3: type_17,
member_4: u32,
member_5: type_18,
member_6: type_19,
member_7: type_19,
member_8: type_20,
member_9: type_21,
member_10: f32,
member_11: type_18,
member_12: type_4,
member_13: type_9,
member_14: type_22,
member_15: type_22,
member_16: type_22,
member_17: type_22,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_24 {
member: type_23,
}
struct type_27 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_28 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_29 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
struct type_30 {
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_24;
@group(0) @binding(1)
var<storage> global_2: type_15;
@group(0) @binding(3)
var<storage> global_3: type_15;
@group(0) @binding(4)
var<storage> global_4: type_15;
@group(0) @binding(6)
var<storage, read_write> global_5: type_11;
@group(0) @binding(5)
var<storage> global_6: type_11;
@group(0) @binding(2)
var<storage> global_7: type_15;
fn function_() {
var local: type_27;
var local_1: vec3<f32>;
var local_2: type_27;
var local_3: vec3<f32>;
var local_4: type_27;
var local_5: vec3<f32>;
var local_6: type_27;
var local_7: vec3<f32>;
var phi_1243_: u32;
var phi_4744_: type_28;
var phi_5390_: type_29;
var phi_6223_: type_5;
var phi_7333_: type_30;
var phi_7485_: vec3<f32>;
var phi_7486_: f32;
let _e85 = global;
let _e88 = arrayLength((&global_2.member));
let _e95 = arrayLength((&global_4.member));
let _e97 = arrayLength((&global_6.member));
let _e102 = global_1.member.member_2;
let _e105 = global_1.member.member;
let _e113 = (_e85.x + _e102.member);
let _e115 = (_e85.y + _e102.member_1);
if (_e113 < _e102.member_2) {
if (_e115 < _e102.member_3) {
let _e118 = (_e105.member * _e105.member_1);
let _e120 = ((_e115 * _e105.member) + _e113);
let _e121 = bitcast<i32>(_e120);
let _e123 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e125 = select(_e123, _e121, (_e121 < _e123));
let _e131 = global_5.member[bitcast<u32>(select(0i, _e125, (_e125 > 0i)))];
let _e132 = (_e118 + _e120);
let _e133 = bitcast<i32>(_e132);
let _e135 = select(_e123, _e133, (_e133 < _e123));
let _e141 = global_5.member[bitcast<u32>(select(0i, _e135, (_e135 > 0i)))];
let _e143 = ((2u * _e118) + _e120);
let _e144 = bitcast<i32>(_e143);
let _e146 = select(_e123, _e144, (_e144 < _e123));
let _e152 = global_5.member[bitcast<u32>(select(0i, _e146, (_e146 > 0i)))];
let _e154 = ((3u * _e118) + _e120);
let _e155 = bitcast<i32>(_e154);
let _e157 = select(_e123, _e155, (_e155 < _e123));
let _e163 = global_5.member[bitcast<u32>(select(0i, _e157, (_e157 > 0i)))];
let _e165 = ((4u * _e118) + _e120);
let _e166 = bitcast<i32>(_e165);
let _e168 = select(_e123, _e166, (_e166 < _e123));
let _e174 = global_5.member[bitcast<u32>(select(0i, _e168, (_e168 > 0i)))];
let _e176 = ((5u * _e118) + _e120);
let _e177 = bitcast<i32>(_e176);
let _e179 = select(_e123, _e177, (_e177 < _e123));
let _e185 = global_5.member[bitcast<u32>(select(0i, _e179, (_e179 > 0i)))];
let _e187 = ((6u * _e118) + _e120);
let _e188 = bitcast<i32>(_e187);
let _e190 = select(_e123, _e188, (_e188 < _e123));
let _e196 = global_5.member[bitcast<u32>(select(0i, _e190, (_e190 > 0i)))];
let _e198 = ((7u * _e118) + _e120);
let _e199 = bitcast<i32>(_e198);
let _e201 = select(_e123, _e199, (_e199 < _e123));
let _e207 = global_5.member[bitcast<u32>(select(0i, _e201, (_e201 > 0i)))];
let _e209 = ((8u * _e118) + _e120);
let _e210 = bitcast<i32>(_e209);
let _e212 = select(_e123, _e210, (_e210 < _e123));
let _e218 = global_5.member[bitcast<u32>(select(0i, _e212, (_e212 > 0i)))];
let _e222 = global_1.member.member_8.member;
let _e226 = global_1.member.member_8.member_1;
let _e227 = (_e222 * _e226);
if (_e97 >= (_e227 * 2u)) {
let _e231 = bitcast<i32>((_e115 * _e222));
let _e233 = bitcast<i32>(_e113);
let _e238 = global_6.member[bitcast<u32>((_e231 + _e233))];
let _e244 = global_6.member[bitcast<u32>(((bitcast<i32>(_e227) + _e231) + _e233))];
let _e245 = f32(_e233);
let _e247 = f32(bitcast<i32>(_e115));
let _e253 = global_1.member.member_5.member;
let _e257 = global_1.member.member_8.member_8;
let _e258 = (_e253 - _e257);
let _e262 = global_1.member.member_8.member_2;
let _e266 = global_1.member.member_8.member_6;
let _e273 = global_1.member.member_8.member_4;
let _e275 = ((_e262 + (_e266 * _e258)) + (((_e245 - _e238) + 0.5f) * _e273));
let _e279 = global_1.member.member_8.member_3;
let _e283 = global_1.member.member_8.member_7;
let _e288 = ((_e279 + (_e283 * _e258)) + (((_e247 - _e244) + 0.5f) * _e273));
let _e292 = global_1.member.member_5.member_1;
let _e293 = (_e292 - _e257);
let _e298 = ((_e262 + (_e266 * _e293)) + ((_e245 + 0.5f) * _e273));
let _e303 = ((_e279 + (_e283 * _e293)) + ((_e247 + 0.5f) * _e273));
let _e307 = global_1.member.member_6.member;
let _e318 = ((((_e307.member.member * _e275) + (_e307.member.member_1 * _e288)) + (_e307.member.member_2 * _e253)) + _e307.member_1);
let _e322 = global_1.member.member_6.member_1;
let _e333 = ((((_e322.member.member * _e275) + (_e322.member.member_1 * _e288)) + (_e322.member.member_2 * _e253)) + _e322.member_1);
let _e337 = global_1.member.member_6.member_2;
let _e348 = ((((_e337.member.member * _e275) + (_e337.member.member_1 * _e288)) + (_e337.member.member_2 * _e253)) + _e337.member_1);
let _e354 = ((((_e307.member.member * _e298) + (_e307.member.member_1 * _e303)) + (_e307.member.member_2 * _e292)) + _e307.member_1);
let _e360 = ((((_e322.member.member * _e298) + (_e322.member.member_1 * _e303)) + (_e322.member.member_2 * _e292)) + _e322.member_1);
let _e366 = ((((_e337.member.member * _e298) + (_e337.member.member_1 * _e303)) + (_e337.member.member_2 * _e292)) + _e337.member_1);
let _e372 = global_1.member.member_6.member_3.member;
let _e373 = (_e372 - 1f);
let _e382 = global_1.member.member_6.member_3.member_1;
let _e383 = (_e382 - 1f);
let _e392 = global_1.member.member_6.member_3.member_2;
let _e393 = (_e392 - 1f);
let _e412 = global_1.member.member_6.member_4;
let _e413 = (_e372 - 0.5f);
let _e415 = select(-0.5f, _e354, (_e354 > -0.5f));
let _e417 = select(_e413, _e415, (_e415 < _e413));
let _e418 = (_e382 - 0.5f);
let _e420 = select(-0.5f, _e360, (_e360 > -0.5f));
let _e422 = select(_e418, _e420, (_e420 < _e418));
let _e423 = (_e392 - 0.5f);
let _e425 = select(-0.5f, _e366, (_e366 > -0.5f));
let _e427 = select(_e423, _e425, (_e425 < _e423));
let _e433 = bitcast<f32>((bitcast<u32>((_e354 - _e318)) & 2147483647u));
let _e436 = bitcast<f32>((bitcast<u32>((_e360 - _e333)) & 2147483647u));
let _e438 = select(_e436, _e433, (_e433 > _e436));
let _e441 = bitcast<f32>((bitcast<u32>((_e366 - _e348)) & 2147483647u));
let _e450 = bitcast<f32>((bitcast<u32>((_e354 - _e417)) & 2147483647u));
let _e453 = bitcast<f32>((bitcast<u32>((_e360 - _e422)) & 2147483647u));
let _e455 = select(_e453, _e450, (_e450 > _e453));
let _e458 = bitcast<f32>((bitcast<u32>((_e366 - _e427)) & 2147483647u));
let _e462 = (_e417 + 0.5f);
let _e464 = select(0f, _e462, (_e462 > 0f));
let _e466 = select(_e373, _e464, (_e464 < _e373));
let _e473 = select(0i, select(select(i32(_e466), i32(-2147483648), (_e466 < -2147483600f)), 2147483647i, (_e466 > 2147483500f)), (_e466 == _e466));
let _e481 = global_1.member.member_6.member_12;
let _e482 = (_e481 & 31u);
let _e485 = (_e422 + 0.5f);
let _e487 = select(0f, _e485, (_e485 > 0f));
let _e489 = select(_e383, _e487, (_e487 < _e383));
let _e496 = select(0i, select(select(i32(_e489), i32(-2147483648), (_e489 < -2147483600f)), 2147483647i, (_e489 > 2147483500f)), (_e489 == _e489));
let _e503 = (_e427 + 0.5f);
let _e505 = select(0f, _e503, (_e503 > 0f));
let _e507 = select(_e393, _e505, (_e505 < _e393));
let _e514 = select(0i, select(select(i32(_e507), i32(-2147483648), (_e507 < -2147483600f)), 2147483647i, (_e507 > 2147483500f)), (_e507 == _e507));
let _e525 = global_1.member.member_6.member_9.member;
let _e531 = global_1.member.member_6.member_9.member_1;
let _e536 = global_1.member.member_6.member_10;
let _e542 = ((bitcast<i32>(_e536) + ((_e473 - select(0i, 1i, (_e466 < f32(_e473)))) >> bitcast<u32>(_e482))) + (bitcast<i32>(_e525) * (((_e496 - select(0i, 1i, (_e489 < f32(_e496)))) >> bitcast<u32>(_e482)) + (bitcast<i32>(_e531) * ((_e514 - select(0i, 1i, (_e507 < f32(_e514)))) >> bitcast<u32>(_e482))))));
let _e544 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e546 = select(_e544, _e542, (_e542 < _e544));
let _e552 = global_3.member[bitcast<u32>(select(0i, _e546, (_e546 > 0i)))];
let _e559 = global_1.member.member_7.member;
let _e574 = global_1.member.member_7.member_1;
let _e589 = global_1.member.member_7.member_2;
let _e606 = ((((_e559.member.member * _e298) + (_e559.member.member_1 * _e303)) + (_e559.member.member_2 * _e292)) + _e559.member_1);
let _e612 = ((((_e574.member.member * _e298) + (_e574.member.member_1 * _e303)) + (_e574.member.member_2 * _e292)) + _e574.member_1);
let _e618 = ((((_e589.member.member * _e298) + (_e589.member.member_1 * _e303)) + (_e589.member.member_2 * _e292)) + _e589.member_1);
let _e622 = global_1.member.member_7.member_4;
let _e627 = global_1.member.member_7.member_3.member;
let _e628 = (_e627 - 0.5f);
let _e630 = select(-0.5f, _e606, (_e606 > -0.5f));
let _e632 = select(_e628, _e630, (_e630 < _e628));
let _e637 = global_1.member.member_7.member_3.member_1;
let _e638 = (_e637 - 0.5f);
let _e640 = select(-0.5f, _e612, (_e612 > -0.5f));
let _e642 = select(_e638, _e640, (_e640 < _e638));
let _e647 = global_1.member.member_7.member_3.member_2;
let _e648 = (_e647 - 0.5f);
let _e650 = select(-0.5f, _e618, (_e618 > -0.5f));
let _e652 = select(_e648, _e650, (_e650 < _e648));
let _e658 = bitcast<f32>((bitcast<u32>((_e606 - ((((_e559.member.member * _e275) + (_e559.member.member_1 * _e288)) + (_e559.member.member_2 * _e253)) + _e559.member_1))) & 2147483647u));
let _e661 = bitcast<f32>((bitcast<u32>((_e612 - ((((_e574.member.member * _e275) + (_e574.member.member_1 * _e288)) + (_e574.member.member_2 * _e253)) + _e574.member_1))) & 2147483647u));
let _e663 = select(_e661, _e658, (_e658 > _e661));
let _e666 = bitcast<f32>((bitcast<u32>((_e618 - ((((_e589.member.member * _e275) + (_e589.member.member_1 * _e288)) + (_e589.member.member_2 * _e253)) + _e589.member_1))) & 2147483647u));
let _e675 = bitcast<f32>((bitcast<u32>((_e606 - _e632)) & 2147483647u));
let _e678 = bitcast<f32>((bitcast<u32>((_e612 - _e642)) & 2147483647u));
let _e680 = select(_e678, _e675, (_e675 > _e678));
let _e683 = bitcast<f32>((bitcast<u32>((_e618 - _e652)) & 2147483647u));
let _e687 = (_e632 + 0.5f);
let _e688 = (_e627 - 1f);
let _e690 = select(0f, _e687, (_e687 > 0f));
let _e692 = select(_e688, _e690, (_e690 < _e688));
let _e699 = select(0i, select(select(i32(_e692), i32(-2147483648), (_e692 < -2147483600f)), 2147483647i, (_e692 > 2147483500f)), (_e692 == _e692));
let _e707 = global_1.member.member_7.member_12;
let _e708 = (_e707 & 31u);
let _e711 = (_e642 + 0.5f);
let _e712 = (_e637 - 1f);
let _e714 = select(0f, _e711, (_e711 > 0f));
let _e716 = select(_e712, _e714, (_e714 < _e712));
let _e723 = select(0i, select(select(i32(_e716), i32(-2147483648), (_e716 < -2147483600f)), 2147483647i, (_e716 > 2147483500f)), (_e716 == _e716));
let _e730 = (_e652 + 0.5f);
let _e731 = (_e647 - 1f);
let _e733 = select(0f, _e730, (_e730 > 0f));
let _e735 = select(_e731, _e733, (_e733 < _e731));
let _e742 = select(0i, select(select(i32(_e735), i32(-2147483648), (_e735 < -2147483600f)), 2147483647i, (_e735 > 2147483500f)), (_e735 == _e735));
let _e753 = global_1.member.member_7.member_9.member;
let _e759 = global_1.member.member_7.member_9.member_1;
let _e764 = global_1.member.member_7.member_10;
let _e770 = ((bitcast<i32>(_e764) + ((_e699 - select(0i, 1i, (_e692 < f32(_e699)))) >> bitcast<u32>(_e708))) + (bitcast<i32>(_e753) * (((_e723 - select(0i, 1i, (_e716 < f32(_e723)))) >> bitcast<u32>(_e708)) + (bitcast<i32>(_e759) * ((_e742 - select(0i, 1i, (_e735 < f32(_e742)))) >> bitcast<u32>(_e708))))));
let _e772 = select(_e544, _e770, (_e770 < _e544));
let _e778 = global_3.member[bitcast<u32>(select(0i, _e772, (_e772 > 0i)))];
let _e784 = global_1.member.member_1;
phi_1243_ = select(select(7u, 3u, (((((((_e318 >= 0f) && (_e318 <= _e373)) && (_e333 >= 0f)) && (_e333 <= _e383)) && (_e348 >= 0f)) && (_e348 <= _e393)) && ((((((_e354 >= 0f) && (_e354 <= _e373)) && (_e360 >= 0f)) && (_e360 <= _e383)) && (_e366 >= 0f)) && (_e366 <= _e393)))), 1u, (((_e784 & 64u) != 0u) || ((((select(_e441, _e438, (_e438 > _e441)) <= _e412) && ((select(_e458, _e455, (_e455 > _e458)) > _e412) || (_e552 != 0u))) && ((select(_e666, _e663, (_e663 > _e666)) <= _e622) && ((select(_e683, _e680, (_e680 > _e683)) > _e622) || (_e778 != 0u)))) && ((_e784 & 32u) != 0u))));
} else {
phi_1243_ = 7u;
}
let _e794 = phi_1243_;
if (_e794 > 1u) {
let _e800 = bitcast<i32>(((_e115 * _e222) + _e113));
let _e803 = (bitcast<i32>(_e97) - 1i);
let _e805 = select(_e803, _e800, (_e800 < _e803));
let _e811 = global_6.member[bitcast<u32>(select(0i, _e805, (_e805 > 0i)))];
let _e812 = (bitcast<i32>(_e227) + _e800);
let _e814 = select(_e803, _e812, (_e812 < _e803));
let _e820 = global_6.member[bitcast<u32>(select(0i, _e814, (_e814 > 0i)))];
let _e822 = f32(bitcast<i32>(_e113));
let _e824 = f32(bitcast<i32>(_e115));
let _e830 = global_1.member.member_5.member;
let _e834 = global_1.member.member_8.member_8;
let _e835 = (_e830 - _e834);
let _e839 = global_1.member.member_8.member_2;
let _e843 = global_1.member.member_8.member_6;
let _e850 = global_1.member.member_8.member_4;
let _e852 = ((_e839 + (_e843 * _e835)) + (((_e822 - _e811) + 0.5f) * _e850));
let _e856 = global_1.member.member_8.member_3;
let _e860 = global_1.member.member_8.member_7;
let _e865 = ((_e856 + (_e860 * _e835)) + (((_e824 - _e820) + 0.5f) * _e850));
let _e869 = global_1.member.member_5.member_1;
let _e870 = (_e869 - _e834);
let _e875 = ((_e839 + (_e843 * _e870)) + ((_e822 + 0.5f) * _e850));
let _e880 = ((_e856 + (_e860 * _e870)) + ((_e824 + 0.5f) * _e850));
let _e884 = global_1.member.member_6.member;
let _e895 = ((((_e884.member.member * _e852) + (_e884.member.member_1 * _e865)) + (_e884.member.member_2 * _e830)) + _e884.member_1);
let _e899 = global_1.member.member_6.member_1;
let _e910 = ((((_e899.member.member * _e852) + (_e899.member.member_1 * _e865)) + (_e899.member.member_2 * _e830)) + _e899.member_1);
let _e914 = global_1.member.member_6.member_2;
let _e925 = ((((_e914.member.member * _e852) + (_e914.member.member_1 * _e865)) + (_e914.member.member_2 * _e830)) + _e914.member_1);
let _e931 = ((((_e884.member.member * _e875) + (_e884.member.member_1 * _e880)) + (_e884.member.member_2 * _e869)) + _e884.member_1);
let _e937 = ((((_e899.member.member * _e875) + (_e899.member.member_1 * _e880)) + (_e899.member.member_2 * _e869)) + _e899.member_1);
let _e943 = ((((_e914.member.member * _e875) + (_e914.member.member_1 * _e880)) + (_e914.member.member_2 * _e869)) + _e914.member_1);
let _e947 = global_1.member.member_7.member;
let _e958 = ((((_e947.member.member * _e875) + (_e947.member.member_1 * _e880)) + (_e947.member.member_2 * _e869)) + _e947.member_1);
let _e962 = global_1.member.member_7.member_1;
let _e973 = ((((_e962.member.member * _e875) + (_e962.member.member_1 * _e880)) + (_e962.member.member_2 * _e869)) + _e962.member_1);
let _e977 = global_1.member.member_7.member_2;
let _e988 = ((((_e977.member.member * _e875) + (_e977.member.member_1 * _e880)) + (_e977.member.member_2 * _e869)) + _e977.member_1);
let _e990 = (_e105.member_2 == 2u);
let _e993 = (((_e105.member_2 == 1u) || _e990) || (_e105.member_2 == 5u));
if _e993 {
let _e998 = global_1.member.member_6.member_3.member;
let _e999 = (_e998 - 0.5f);
let _e1001 = select(-0.5f, _e931, (_e931 > -0.5f));
let _e1003 = select(_e999, _e1001, (_e1001 < _e999));
let _e1008 = global_1.member.member_6.member_3.member_1;
let _e1009 = (_e1008 - 0.5f);
let _e1011 = select(-0.5f, _e937, (_e937 > -0.5f));
let _e1013 = select(_e1009, _e1011, (_e1011 < _e1009));
let _e1018 = global_1.member.member_6.member_3.member_2;
let _e1019 = (_e1018 - 0.5f);
let _e1021 = select(-0.5f, _e943, (_e943 > -0.5f));
let _e1023 = select(_e1019, _e1021, (_e1021 < _e1019));
let _e1025 = select(-1f, _e1003, (_e1003 > -1f));
let _e1027 = select(_e998, _e1025, (_e1025 < _e998));
let _e1034 = select(0i, select(select(i32(_e1027), i32(-2147483648), (_e1027 < -2147483600f)), 2147483647i, (_e1027 > 2147483500f)), (_e1027 == _e1027));
let _e1038 = (_e1034 - select(0i, 1i, (_e1027 < f32(_e1034))));
let _e1040 = select(-1f, _e1013, (_e1013 > -1f));
let _e1042 = select(_e1008, _e1040, (_e1040 < _e1008));
let _e1049 = select(0i, select(select(i32(_e1042), i32(-2147483648), (_e1042 < -2147483600f)), 2147483647i, (_e1042 > 2147483500f)), (_e1042 == _e1042));
let _e1053 = (_e1049 - select(0i, 1i, (_e1042 < f32(_e1049))));
let _e1055 = select(-1f, _e1023, (_e1023 > -1f));
let _e1057 = select(_e1018, _e1055, (_e1055 < _e1018));
let _e1064 = select(0i, select(select(i32(_e1057), i32(-2147483648), (_e1057 < -2147483600f)), 2147483647i, (_e1057 > 2147483500f)), (_e1057 == _e1057));
let _e1068 = (_e1064 - select(0i, 1i, (_e1057 < f32(_e1064))));
let _e1072 = global_1.member.member_6.member_7;
let _e1076 = global_1.member.member_6.member_8;
let _e1084 = (select(0i, select(select(i32(_e1008), i32(-2147483648), (_e1008 < -2147483600f)), 2147483647i, (_e1008 > 2147483500f)), (_e1008 == _e1008)) - 1i);
let _e1087 = (_e1053 + 1i);
let _e1097 = (select(0i, select(select(i32(_e1018), i32(-2147483648), (_e1018 < -2147483600f)), 2147483647i, (_e1018 > 2147483500f)), (_e1018 == _e1018)) - 1i);
let _e1100 = (_e1068 + 1i);
let _e1110 = (select(0i, select(select(i32(_e998), i32(-2147483648), (_e998 < -2147483600f)), 2147483647i, (_e998 > 2147483500f)), (_e998 == _e998)) - 1i);
let _e1111 = (_e1038 - 1i);
let _e1116 = (_e1038 + 1i);
let _e1119 = (_e1038 + 2i);
let _e1122 = (select(0i, _e1053, (_e1053 > 0i)) * _e1072);
let _e1123 = (select(_e1084, _e1087, (_e1087 < _e1084)) * _e1072);
let _e1124 = (select(0i, _e1068, (_e1068 > 0i)) * _e1076);
let _e1125 = (select(_e1097, _e1100, (_e1100 < _e1097)) * _e1076);
local_6 = type_27(array<i32, 4>(select(0i, _e1111, (_e1111 > 0i)), select(0i, _e1038, (_e1038 > 0i)), select(_e1110, _e1116, (_e1116 < _e1110)), select(_e1110, _e1119, (_e1119 < _e1110))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_7 = vec3<f32>((_e1003 - f32(_e1038)), (_e1013 - f32(_e1053)), (_e1023 - f32(_e1068)));
let _e1136 = (_e1124 + _e1122);
let _e1138 = (bitcast<i32>(_e88) - 1i);
let _e1141 = local_6.member[1u];
let _e1142 = (_e1136 + _e1141);
let _e1144 = select(_e1138, _e1142, (_e1142 < _e1138));
let _e1149 = global_2.member[bitcast<u32>(select(0i, _e1144, (_e1144 > 0i)))];
let _e1150 = bitcast<f32>(_e1149);
let _e1153 = local_6.member[2u];
let _e1154 = (_e1136 + _e1153);
let _e1156 = select(_e1138, _e1154, (_e1154 < _e1138));
let _e1161 = global_2.member[bitcast<u32>(select(0i, _e1156, (_e1156 > 0i)))];
let _e1163 = local_7[0u];
let _e1166 = (_e1150 + ((bitcast<f32>(_e1161) - _e1150) * _e1163));
let _e1167 = (_e1124 + _e1123);
let _e1168 = local_6.member[1u];
let _e1169 = (_e1167 + _e1168);
let _e1171 = select(_e1138, _e1169, (_e1169 < _e1138));
let _e1176 = global_2.member[bitcast<u32>(select(0i, _e1171, (_e1171 > 0i)))];
let _e1177 = bitcast<f32>(_e1176);
let _e1178 = local_6.member[2u];
let _e1179 = (_e1167 + _e1178);
let _e1181 = select(_e1138, _e1179, (_e1179 < _e1138));
let _e1186 = global_2.member[bitcast<u32>(select(0i, _e1181, (_e1181 > 0i)))];
let _e1188 = local_7[0u];
let _e1192 = (_e1125 + _e1122);
let _e1193 = local_6.member[1u];
let _e1194 = (_e1192 + _e1193);
let _e1196 = select(_e1138, _e1194, (_e1194 < _e1138));
let _e1201 = global_2.member[bitcast<u32>(select(0i, _e1196, (_e1196 > 0i)))];
let _e1202 = bitcast<f32>(_e1201);
let _e1203 = local_6.member[2u];
let _e1204 = (_e1192 + _e1203);
let _e1206 = select(_e1138, _e1204, (_e1204 < _e1138));
let _e1211 = global_2.member[bitcast<u32>(select(0i, _e1206, (_e1206 > 0i)))];
let _e1213 = local_7[0u];
let _e1216 = (_e1202 + ((bitcast<f32>(_e1211) - _e1202) * _e1213));
let _e1217 = (_e1125 + _e1123);
let _e1218 = local_6.member[1u];
let _e1219 = (_e1217 + _e1218);
let _e1221 = select(_e1138, _e1219, (_e1219 < _e1138));
let _e1226 = global_2.member[bitcast<u32>(select(0i, _e1221, (_e1221 > 0i)))];
let _e1227 = bitcast<f32>(_e1226);
let _e1228 = local_6.member[2u];
let _e1229 = (_e1217 + _e1228);
let _e1231 = select(_e1138, _e1229, (_e1229 < _e1138));
let _e1236 = global_2.member[bitcast<u32>(select(0i, _e1231, (_e1231 > 0i)))];
let _e1238 = local_7[0u];
let _e1243 = local_7[1u];
let _e1246 = (_e1166 + (((_e1177 + ((bitcast<f32>(_e1186) - _e1177) * _e1188)) - _e1166) * _e1243));
let _e1247 = local_7[1u];
let _e1252 = local_7[2u];
let _e1259 = global_1.member.member_6.member_5;
let _e1264 = global_1.member.member_6.member_6;
let _e1265 = (((_e1246 + (((_e1216 + (((_e1227 + ((bitcast<f32>(_e1236) - _e1227) * _e1238)) - _e1216) * _e1247)) - _e1246) * _e1252)) * _e1259) + _e1264);
let _e1267 = select(0f, _e1265, (_e1265 > 0f));
let _e1274 = global_1.member.member_7.member_3.member;
let _e1275 = (_e1274 - 0.5f);
let _e1277 = select(-0.5f, _e958, (_e958 > -0.5f));
let _e1279 = select(_e1275, _e1277, (_e1277 < _e1275));
let _e1284 = global_1.member.member_7.member_3.member_1;
let _e1285 = (_e1284 - 0.5f);
let _e1287 = select(-0.5f, _e973, (_e973 > -0.5f));
let _e1289 = select(_e1285, _e1287, (_e1287 < _e1285));
let _e1294 = global_1.member.member_7.member_3.member_2;
let _e1295 = (_e1294 - 0.5f);
let _e1297 = select(-0.5f, _e988, (_e988 > -0.5f));
let _e1299 = select(_e1295, _e1297, (_e1297 < _e1295));
let _e1301 = select(-1f, _e1279, (_e1279 > -1f));
let _e1303 = select(_e1274, _e1301, (_e1301 < _e1274));
let _e1310 = select(0i, select(select(i32(_e1303), i32(-2147483648), (_e1303 < -2147483600f)), 2147483647i, (_e1303 > 2147483500f)), (_e1303 == _e1303));
let _e1314 = (_e1310 - select(0i, 1i, (_e1303 < f32(_e1310))));
let _e1316 = select(-1f, _e1289, (_e1289 > -1f));
let _e1318 = select(_e1284, _e1316, (_e1316 < _e1284));
let _e1325 = select(0i, select(select(i32(_e1318), i32(-2147483648), (_e1318 < -2147483600f)), 2147483647i, (_e1318 > 2147483500f)), (_e1318 == _e1318));
let _e1329 = (_e1325 - select(0i, 1i, (_e1318 < f32(_e1325))));
let _e1331 = select(-1f, _e1299, (_e1299 > -1f));
let _e1333 = select(_e1294, _e1331, (_e1331 < _e1294));
let _e1340 = select(0i, select(select(i32(_e1333), i32(-2147483648), (_e1333 < -2147483600f)), 2147483647i, (_e1333 > 2147483500f)), (_e1333 == _e1333));
let _e1344 = (_e1340 - select(0i, 1i, (_e1333 < f32(_e1340))));
let _e1348 = global_1.member.member_7.member_7;
let _e1352 = global_1.member.member_7.member_8;
let _e1360 = (select(0i, select(select(i32(_e1284), i32(-2147483648), (_e1284 < -2147483600f)), 2147483647i, (_e1284 > 2147483500f)), (_e1284 == _e1284)) - 1i);
let _e1361 = (_e1329 - 1i);
let _e1366 = (_e1329 + 1i);
let _e1369 = (_e1329 + 2i);
let _e1379 = (select(0i, select(select(i32(_e1294), i32(-2147483648), (_e1294 < -2147483600f)), 2147483647i, (_e1294 > 2147483500f)), (_e1294 == _e1294)) - 1i);
let _e1380 = (_e1344 - 1i);
let _e1385 = (_e1344 + 1i);
let _e1388 = (_e1344 + 2i);
let _e1398 = (select(0i, select(select(i32(_e1274), i32(-2147483648), (_e1274 < -2147483600f)), 2147483647i, (_e1274 > 2147483500f)), (_e1274 == _e1274)) - 1i);
let _e1399 = (_e1314 - 1i);
let _e1404 = (_e1314 + 1i);
let _e1407 = (_e1314 + 2i);
let _e1410 = (select(0i, _e1361, (_e1361 > 0i)) * _e1348);
let _e1411 = (select(0i, _e1329, (_e1329 > 0i)) * _e1348);
let _e1412 = (select(_e1360, _e1366, (_e1366 < _e1360)) * _e1348);
let _e1413 = (select(_e1360, _e1369, (_e1369 < _e1360)) * _e1348);
let _e1414 = (select(0i, _e1380, (_e1380 > 0i)) * _e1352);
let _e1415 = (select(0i, _e1344, (_e1344 > 0i)) * _e1352);
let _e1416 = (select(_e1379, _e1385, (_e1385 < _e1379)) * _e1352);
let _e1417 = (select(_e1379, _e1388, (_e1388 < _e1379)) * _e1352);
local_4 = type_27(array<i32, 4>(select(0i, _e1399, (_e1399 > 0i)), select(0i, _e1314, (_e1314 > 0i)), select(_e1398, _e1404, (_e1404 < _e1398)), select(_e1398, _e1407, (_e1407 < _e1398))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_5 = vec3<f32>((_e1279 - f32(_e1314)), (_e1289 - f32(_e1329)), (_e1299 - f32(_e1344)));
let _e1428 = (_e1415 + _e1411);
let _e1431 = local_4.member[0u];
let _e1432 = (_e1428 + _e1431);
let _e1434 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e1436 = select(_e1434, _e1432, (_e1432 < _e1434));
let _e1441 = global_7.member[bitcast<u32>(select(0i, _e1436, (_e1436 > 0i)))];
let _e1442 = bitcast<f32>(_e1441);
let _e1445 = local_4.member[1u];
let _e1446 = (_e1428 + _e1445);
let _e1448 = select(_e1434, _e1446, (_e1446 < _e1434));
let _e1453 = global_7.member[bitcast<u32>(select(0i, _e1448, (_e1448 > 0i)))];
let _e1454 = bitcast<f32>(_e1453);
let _e1457 = local_4.member[2u];
let _e1458 = (_e1428 + _e1457);
let _e1460 = select(_e1434, _e1458, (_e1458 < _e1434));
let _e1465 = global_7.member[bitcast<u32>(select(0i, _e1460, (_e1460 > 0i)))];
let _e1466 = bitcast<f32>(_e1465);
let _e1469 = local_4.member[3u];
let _e1470 = (_e1428 + _e1469);
let _e1472 = select(_e1434, _e1470, (_e1470 < _e1434));
let _e1477 = global_7.member[bitcast<u32>(select(0i, _e1472, (_e1472 > 0i)))];
let _e1479 = local_5[0u];
let _e1482 = (_e1442 + ((_e1454 - _e1442) * _e1479));
let _e1483 = local_5[0u];
let _e1486 = (_e1454 + ((_e1466 - _e1454) * _e1483));
let _e1487 = local_5[0u];
let _e1490 = (_e1466 + ((bitcast<f32>(_e1477) - _e1466) * _e1487));
let _e1491 = (_e1415 + _e1412);
let _e1492 = local_4.member[0u];
let _e1493 = (_e1491 + _e1492);
let _e1495 = select(_e1434, _e1493, (_e1493 < _e1434));
let _e1500 = global_7.member[bitcast<u32>(select(0i, _e1495, (_e1495 > 0i)))];
let _e1501 = bitcast<f32>(_e1500);
let _e1502 = local_4.member[1u];
let _e1503 = (_e1491 + _e1502);
let _e1505 = select(_e1434, _e1503, (_e1503 < _e1434));
let _e1510 = global_7.member[bitcast<u32>(select(0i, _e1505, (_e1505 > 0i)))];
let _e1511 = bitcast<f32>(_e1510);
let _e1512 = local_4.member[2u];
let _e1513 = (_e1491 + _e1512);
let _e1515 = select(_e1434, _e1513, (_e1513 < _e1434));
let _e1520 = global_7.member[bitcast<u32>(select(0i, _e1515, (_e1515 > 0i)))];
let _e1521 = bitcast<f32>(_e1520);
let _e1522 = local_4.member[3u];
let _e1523 = (_e1491 + _e1522);
let _e1525 = select(_e1434, _e1523, (_e1523 < _e1434));
let _e1530 = global_7.member[bitcast<u32>(select(0i, _e1525, (_e1525 > 0i)))];
let _e1532 = local_5[0u];
let _e1536 = local_5[0u];
let _e1539 = (_e1511 + ((_e1521 - _e1511) * _e1536));
let _e1540 = local_5[0u];
let _e1544 = (_e1416 + _e1411);
let _e1545 = local_4.member[0u];
let _e1546 = (_e1544 + _e1545);
let _e1548 = select(_e1434, _e1546, (_e1546 < _e1434));
let _e1553 = global_7.member[bitcast<u32>(select(0i, _e1548, (_e1548 > 0i)))];
let _e1554 = bitcast<f32>(_e1553);
let _e1555 = local_4.member[1u];
let _e1556 = (_e1544 + _e1555);
let _e1558 = select(_e1434, _e1556, (_e1556 < _e1434));
let _e1563 = global_7.member[bitcast<u32>(select(0i, _e1558, (_e1558 > 0i)))];
let _e1564 = bitcast<f32>(_e1563);
let _e1565 = local_4.member[2u];
let _e1566 = (_e1544 + _e1565);
let _e1568 = select(_e1434, _e1566, (_e1566 < _e1434));
let _e1573 = global_7.member[bitcast<u32>(select(0i, _e1568, (_e1568 > 0i)))];
let _e1574 = bitcast<f32>(_e1573);
let _e1575 = local_4.member[3u];
let _e1576 = (_e1544 + _e1575);
let _e1578 = select(_e1434, _e1576, (_e1576 < _e1434));
let _e1583 = global_7.member[bitcast<u32>(select(0i, _e1578, (_e1578 > 0i)))];
let _e1585 = local_5[0u];
let _e1588 = (_e1554 + ((_e1564 - _e1554) * _e1585));
let _e1589 = local_5[0u];
let _e1592 = (_e1564 + ((_e1574 - _e1564) * _e1589));
let _e1593 = local_5[0u];
let _e1596 = (_e1574 + ((bitcast<f32>(_e1583) - _e1574) * _e1593));
let _e1597 = (_e1416 + _e1412);
let _e1598 = local_4.member[0u];
let _e1599 = (_e1597 + _e1598);
let _e1601 = select(_e1434, _e1599, (_e1599 < _e1434));
let _e1606 = global_7.member[bitcast<u32>(select(0i, _e1601, (_e1601 > 0i)))];
let _e1607 = bitcast<f32>(_e1606);
let _e1608 = local_4.member[1u];
let _e1609 = (_e1597 + _e1608);
let _e1611 = select(_e1434, _e1609, (_e1609 < _e1434));
let _e1616 = global_7.member[bitcast<u32>(select(0i, _e1611, (_e1611 > 0i)))];
let _e1617 = bitcast<f32>(_e1616);
let _e1618 = local_4.member[2u];
let _e1619 = (_e1597 + _e1618);
let _e1621 = select(_e1434, _e1619, (_e1619 < _e1434));
let _e1626 = global_7.member[bitcast<u32>(select(0i, _e1621, (_e1621 > 0i)))];
let _e1627 = bitcast<f32>(_e1626);
let _e1628 = local_4.member[3u];
let _e1629 = (_e1597 + _e1628);
let _e1631 = select(_e1434, _e1629, (_e1629 < _e1434));
let _e1636 = global_7.member[bitcast<u32>(select(0i, _e1631, (_e1631 > 0i)))];
let _e1638 = local_5[0u];
let _e1642 = local_5[0u];
let _e1645 = (_e1617 + ((_e1627 - _e1617) * _e1642));
let _e1646 = local_5[0u];
let _e1650 = (_e1415 + _e1410);
let _e1651 = local_4.member[1u];
let _e1652 = (_e1650 + _e1651);
let _e1654 = select(_e1434, _e1652, (_e1652 < _e1434));
let _e1659 = global_7.member[bitcast<u32>(select(0i, _e1654, (_e1654 > 0i)))];
let _e1660 = bitcast<f32>(_e1659);
let _e1661 = local_4.member[2u];
let _e1662 = (_e1650 + _e1661);
let _e1664 = select(_e1434, _e1662, (_e1662 < _e1434));
let _e1669 = global_7.member[bitcast<u32>(select(0i, _e1664, (_e1664 > 0i)))];
let _e1671 = local_5[0u];
let _e1674 = (_e1660 + ((bitcast<f32>(_e1669) - _e1660) * _e1671));
let _e1675 = (_e1415 + _e1413);
let _e1676 = local_4.member[1u];
let _e1677 = (_e1675 + _e1676);
let _e1679 = select(_e1434, _e1677, (_e1677 < _e1434));
let _e1684 = global_7.member[bitcast<u32>(select(0i, _e1679, (_e1679 > 0i)))];
let _e1685 = bitcast<f32>(_e1684);
let _e1686 = local_4.member[2u];
let _e1687 = (_e1675 + _e1686);
let _e1689 = select(_e1434, _e1687, (_e1687 < _e1434));
let _e1694 = global_7.member[bitcast<u32>(select(0i, _e1689, (_e1689 > 0i)))];
let _e1696 = local_5[0u];
let _e1700 = (_e1416 + _e1410);
let _e1701 = local_4.member[1u];
let _e1702 = (_e1700 + _e1701);
let _e1704 = select(_e1434, _e1702, (_e1702 < _e1434));
let _e1709 = global_7.member[bitcast<u32>(select(0i, _e1704, (_e1704 > 0i)))];
let _e1710 = bitcast<f32>(_e1709);
let _e1711 = local_4.member[2u];
let _e1712 = (_e1700 + _e1711);
let _e1714 = select(_e1434, _e1712, (_e1712 < _e1434));
let _e1719 = global_7.member[bitcast<u32>(select(0i, _e1714, (_e1714 > 0i)))];
let _e1721 = local_5[0u];
let _e1724 = (_e1710 + ((bitcast<f32>(_e1719) - _e1710) * _e1721));
let _e1725 = (_e1416 + _e1413);
let _e1726 = local_4.member[1u];
let _e1727 = (_e1725 + _e1726);
let _e1729 = select(_e1434, _e1727, (_e1727 < _e1434));
let _e1734 = global_7.member[bitcast<u32>(select(0i, _e1729, (_e1729 > 0i)))];
let _e1735 = bitcast<f32>(_e1734);
let _e1736 = local_4.member[2u];
let _e1737 = (_e1725 + _e1736);
let _e1739 = select(_e1434, _e1737, (_e1737 < _e1434));
let _e1744 = global_7.member[bitcast<u32>(select(0i, _e1739, (_e1739 > 0i)))];
let _e1746 = local_5[0u];
let _e1750 = (_e1414 + _e1411);
let _e1751 = local_4.member[1u];
let _e1752 = (_e1750 + _e1751);
let _e1754 = select(_e1434, _e1752, (_e1752 < _e1434));
let _e1759 = global_7.member[bitcast<u32>(select(0i, _e1754, (_e1754 > 0i)))];
let _e1760 = bitcast<f32>(_e1759);
let _e1761 = local_4.member[2u];
let _e1762 = (_e1750 + _e1761);
let _e1764 = select(_e1434, _e1762, (_e1762 < _e1434));
let _e1769 = global_7.member[bitcast<u32>(select(0i, _e1764, (_e1764 > 0i)))];
let _e1771 = local_5[0u];
let _e1774 = (_e1760 + ((bitcast<f32>(_e1769) - _e1760) * _e1771));
let _e1775 = (_e1417 + _e1411);
let _e1776 = local_4.member[1u];
let _e1777 = (_e1775 + _e1776);
let _e1779 = select(_e1434, _e1777, (_e1777 < _e1434));
let _e1784 = global_7.member[bitcast<u32>(select(0i, _e1779, (_e1779 > 0i)))];
let _e1785 = bitcast<f32>(_e1784);
let _e1786 = local_4.member[2u];
let _e1787 = (_e1775 + _e1786);
let _e1789 = select(_e1434, _e1787, (_e1787 < _e1434));
let _e1794 = global_7.member[bitcast<u32>(select(0i, _e1789, (_e1789 > 0i)))];
let _e1796 = local_5[0u];
let _e1799 = (_e1785 + ((bitcast<f32>(_e1794) - _e1785) * _e1796));
let _e1800 = (_e1414 + _e1412);
let _e1801 = local_4.member[1u];
let _e1802 = (_e1800 + _e1801);
let _e1804 = select(_e1434, _e1802, (_e1802 < _e1434));
let _e1809 = global_7.member[bitcast<u32>(select(0i, _e1804, (_e1804 > 0i)))];
let _e1810 = bitcast<f32>(_e1809);
let _e1811 = local_4.member[2u];
let _e1812 = (_e1800 + _e1811);
let _e1814 = select(_e1434, _e1812, (_e1812 < _e1434));
let _e1819 = global_7.member[bitcast<u32>(select(0i, _e1814, (_e1814 > 0i)))];
let _e1821 = local_5[0u];
let _e1825 = (_e1417 + _e1412);
let _e1826 = local_4.member[1u];
let _e1827 = (_e1825 + _e1826);
let _e1829 = select(_e1434, _e1827, (_e1827 < _e1434));
let _e1834 = global_7.member[bitcast<u32>(select(0i, _e1829, (_e1829 > 0i)))];
let _e1835 = bitcast<f32>(_e1834);
let _e1836 = local_4.member[2u];
let _e1837 = (_e1825 + _e1836);
let _e1839 = select(_e1434, _e1837, (_e1837 < _e1434));
let _e1844 = global_7.member[bitcast<u32>(select(0i, _e1839, (_e1839 > 0i)))];
let _e1846 = local_5[0u];
let _e1851 = local_5[1u];
let _e1854 = (_e1486 + ((_e1539 - _e1486) * _e1851));
let _e1855 = local_5[1u];
let _e1858 = (_e1592 + ((_e1645 - _e1592) * _e1855));
let _e1859 = local_5[1u];
let _e1862 = (_e1482 + (((_e1501 + ((_e1511 - _e1501) * _e1532)) - _e1482) * _e1859));
let _e1863 = local_5[1u];
let _e1868 = local_5[2u];
let _e1872 = local_5[1u];
let _e1875 = (_e1490 + (((_e1521 + ((bitcast<f32>(_e1530) - _e1521) * _e1540)) - _e1490) * _e1872));
let _e1876 = local_5[1u];
let _e1880 = local_5[2u];
let _e1884 = local_5[1u];
let _e1887 = (_e1674 + ((_e1486 - _e1674) * _e1884));
let _e1888 = local_5[1u];
let _e1892 = local_5[2u];
let _e1896 = local_5[1u];
let _e1899 = (_e1539 + (((_e1685 + ((bitcast<f32>(_e1694) - _e1685) * _e1696)) - _e1539) * _e1896));
let _e1900 = local_5[1u];
let _e1904 = local_5[2u];
let _e1908 = local_5[1u];
let _e1911 = (_e1774 + (((_e1810 + ((bitcast<f32>(_e1819) - _e1810) * _e1821)) - _e1774) * _e1908));
let _e1912 = local_5[2u];
let _e1916 = local_5[1u];
let _e1920 = local_5[2u];
let _e1924 = local_5[2u];
let _e1931 = global_1.member.member_7.member_5;
let _e1936 = global_1.member.member_7.member_6;
let _e1937 = (((_e1854 + ((_e1858 - _e1854) * _e1924)) * _e1931) + _e1936);
let _e1939 = select(0f, _e1937, (_e1937 > 0f));
let _e1943 = (((_e1862 + (((_e1588 + (((_e1607 + ((_e1617 - _e1607) * _e1638)) - _e1588) * _e1863)) - _e1862) * _e1868)) * _e1931) + _e1936);
let _e1945 = select(0f, _e1943, (_e1943 > 0f));
let _e1947 = select(1f, _e1945, (_e1945 < 1f));
let _e1949 = (((_e1875 + (((_e1596 + (((_e1627 + ((bitcast<f32>(_e1636) - _e1627) * _e1646)) - _e1596) * _e1876)) - _e1875) * _e1880)) * _e1931) + _e1936);
let _e1951 = select(0f, _e1949, (_e1949 > 0f));
let _e1953 = select(1f, _e1951, (_e1951 < 1f));
let _e1955 = (((_e1887 + (((_e1724 + ((_e1592 - _e1724) * _e1888)) - _e1887) * _e1892)) * _e1931) + _e1936);
let _e1957 = select(0f, _e1955, (_e1955 > 0f));
let _e1959 = select(1f, _e1957, (_e1957 < 1f));
let _e1961 = (((_e1899 + (((_e1645 + (((_e1735 + ((bitcast<f32>(_e1744) - _e1735) * _e1746)) - _e1645) * _e1900)) - _e1899) * _e1904)) * _e1931) + _e1936);
let _e1963 = select(0f, _e1961, (_e1961 > 0f));
let _e1965 = select(1f, _e1963, (_e1963 < 1f));
let _e1967 = (((_e1911 + ((_e1854 - _e1911) * _e1912)) * _e1931) + _e1936);
let _e1969 = select(0f, _e1967, (_e1967 > 0f));
let _e1971 = select(1f, _e1969, (_e1969 < 1f));
let _e1973 = (((_e1858 + (((_e1799 + (((_e1835 + ((bitcast<f32>(_e1844) - _e1835) * _e1846)) - _e1799) * _e1916)) - _e1858) * _e1920)) * _e1931) + _e1936);
let _e1975 = select(0f, _e1973, (_e1973 > 0f));
let _e1977 = select(1f, _e1975, (_e1975 < 1f));
let _e1978 = (select(1f, _e1939, (_e1939 < 1f)) * 1024f);
let _e1979 = (1024f - 1f);
let _e1981 = select(0f, _e1978, (_e1978 > 0f));
let _e1983 = select(_e1979, _e1981, (_e1981 < _e1979));
let _e1990 = select(0i, select(select(i32(_e1983), i32(-2147483648), (_e1983 < -2147483600f)), 2147483647i, (_e1983 > 2147483500f)), (_e1983 == _e1983));
let _e1994 = (_e1990 - select(0i, 1i, (_e1983 < f32(_e1990))));
let _e1995 = (262147i + _e1994);
let _e1997 = (bitcast<i32>(_e95) - 1i);
let _e1999 = select(_e1997, _e1995, (_e1995 < _e1997));
let _e2005 = global_4.member[bitcast<u32>(select(0i, _e1999, (_e1999 > 0i)))];
let _e2015 = select(_e1997, 262146i, (262146i < _e1997));
let _e2021 = global_4.member[bitcast<u32>(select(0i, _e2015, (_e2015 > 0i)))];
let _e2022 = bitcast<f32>(_e2021);
let _e2023 = (f32((bitcast<i32>((_e2005 & 4095u)) - 2048i)) * _e2022);
let _e2025 = select(_e1997, 262144i, (262144i < _e1997));
let _e2031 = global_4.member[bitcast<u32>(select(0i, _e2025, (_e2025 > 0i)))];
let _e2032 = bitcast<f32>(_e2031);
let _e2034 = select(_e1997, 262145i, (262145i < _e1997));
let _e2040 = global_4.member[bitcast<u32>(select(0i, _e2034, (_e2034 > 0i)))];
let _e2041 = bitcast<f32>(_e2040);
let _e2047 = ((_e2032 + (f32(bitcast<i32>((_e2005 >> bitcast<u32>(12u)))) * _e2041)) + (_e2023 * (_e1978 - f32(_e1994))));
let _e2048 = (_e2023 * 1024f);
if _e990 {
let _e2055 = ((0.5f * (_e1953 - _e1947)) * _e2048);
let _e2056 = ((0.5f * (_e1965 - _e1959)) * _e2048);
let _e2057 = ((0.5f * (_e1977 - _e1971)) * _e2048);
phi_4744_ = type_28(_e2047, vec3<f32>(_e2055, _e2056, _e2057), vec3<f32>((_e2055 * _e2047), (_e2056 * _e2047), (_e2057 * _e2047)));
} else {
let _e2064 = (_e1947 * 1024f);
let _e2066 = select(0f, _e2064, (_e2064 > 0f));
let _e2068 = select(_e1979, _e2066, (_e2066 < _e1979));
let _e2075 = select(0i, select(select(i32(_e2068), i32(-2147483648), (_e2068 < -2147483600f)), 2147483647i, (_e2068 > 2147483500f)), (_e2068 == _e2068));
let _e2079 = (_e2075 - select(0i, 1i, (_e2068 < f32(_e2075))));
let _e2080 = (262147i + _e2079);
let _e2082 = select(_e1997, _e2080, (_e2080 < _e1997));
let _e2088 = global_4.member[bitcast<u32>(select(0i, _e2082, (_e2082 > 0i)))];
let _e2103 = ((_e2032 + (f32(bitcast<i32>((_e2088 >> bitcast<u32>(12u)))) * _e2041)) + ((f32((bitcast<i32>((_e2088 & 4095u)) - 2048i)) * _e2022) * (_e2064 - f32(_e2079))));
let _e2104 = (_e1953 * 1024f);
let _e2106 = select(0f, _e2104, (_e2104 > 0f));
let _e2108 = select(_e1979, _e2106, (_e2106 < _e1979));
let _e2115 = select(0i, select(select(i32(_e2108), i32(-2147483648), (_e2108 < -2147483600f)), 2147483647i, (_e2108 > 2147483500f)), (_e2108 == _e2108));
let _e2119 = (_e2115 - select(0i, 1i, (_e2108 < f32(_e2115))));
let _e2120 = (262147i + _e2119);
let _e2122 = select(_e1997, _e2120, (_e2120 < _e1997));
let _e2128 = global_4.member[bitcast<u32>(select(0i, _e2122, (_e2122 > 0i)))];
let _e2143 = ((_e2032 + (f32(bitcast<i32>((_e2128 >> bitcast<u32>(12u)))) * _e2041)) + ((f32((bitcast<i32>((_e2128 & 4095u)) - 2048i)) * _e2022) * (_e2104 - f32(_e2119))));
let _e2144 = (_e1959 * 1024f);
let _e2146 = select(0f, _e2144, (_e2144 > 0f));
let _e2148 = select(_e1979, _e2146, (_e2146 < _e1979));
let _e2155 = select(0i, select(select(i32(_e2148), i32(-2147483648), (_e2148 < -2147483600f)), 2147483647i, (_e2148 > 2147483500f)), (_e2148 == _e2148));
let _e2159 = (_e2155 - select(0i, 1i, (_e2148 < f32(_e2155))));
let _e2160 = (262147i + _e2159);
let _e2162 = select(_e1997, _e2160, (_e2160 < _e1997));
let _e2168 = global_4.member[bitcast<u32>(select(0i, _e2162, (_e2162 > 0i)))];
let _e2183 = ((_e2032 + (f32(bitcast<i32>((_e2168 >> bitcast<u32>(12u)))) * _e2041)) + ((f32((bitcast<i32>((_e2168 & 4095u)) - 2048i)) * _e2022) * (_e2144 - f32(_e2159))));
let _e2184 = (_e1965 * 1024f);
let _e2186 = select(0f, _e2184, (_e2184 > 0f));
let _e2188 = select(_e1979, _e2186, (_e2186 < _e1979));
let _e2195 = select(0i, select(select(i32(_e2188), i32(-2147483648), (_e2188 < -2147483600f)), 2147483647i, (_e2188 > 2147483500f)), (_e2188 == _e2188));
let _e2199 = (_e2195 - select(0i, 1i, (_e2188 < f32(_e2195))));
let _e2200 = (262147i + _e2199);
let _e2202 = select(_e1997, _e2200, (_e2200 < _e1997));
let _e2208 = global_4.member[bitcast<u32>(select(0i, _e2202, (_e2202 > 0i)))];
let _e2223 = ((_e2032 + (f32(bitcast<i32>((_e2208 >> bitcast<u32>(12u)))) * _e2041)) + ((f32((bitcast<i32>((_e2208 & 4095u)) - 2048i)) * _e2022) * (_e2184 - f32(_e2199))));
let _e2224 = (_e1971 * 1024f);
let _e2226 = select(0f, _e2224, (_e2224 > 0f));
let _e2228 = select(_e1979, _e2226, (_e2226 < _e1979));
let _e2235 = select(0i, select(select(i32(_e2228), i32(-2147483648), (_e2228 < -2147483600f)), 2147483647i, (_e2228 > 2147483500f)), (_e2228 == _e2228));
let _e2239 = (_e2235 - select(0i, 1i, (_e2228 < f32(_e2235))));
let _e2240 = (262147i + _e2239);
let _e2242 = select(_e1997, _e2240, (_e2240 < _e1997));
let _e2248 = global_4.member[bitcast<u32>(select(0i, _e2242, (_e2242 > 0i)))];
let _e2263 = ((_e2032 + (f32(bitcast<i32>((_e2248 >> bitcast<u32>(12u)))) * _e2041)) + ((f32((bitcast<i32>((_e2248 & 4095u)) - 2048i)) * _e2022) * (_e2224 - f32(_e2239))));
let _e2264 = (_e1977 * 1024f);
let _e2266 = select(0f, _e2264, (_e2264 > 0f));
let _e2268 = select(_e1979, _e2266, (_e2266 < _e1979));
let _e2275 = select(0i, select(select(i32(_e2268), i32(-2147483648), (_e2268 < -2147483600f)), 2147483647i, (_e2268 > 2147483500f)), (_e2268 == _e2268));
let _e2279 = (_e2275 - select(0i, 1i, (_e2268 < f32(_e2275))));
let _e2280 = (262147i + _e2279);
let _e2282 = select(_e1997, _e2280, (_e2280 < _e1997));
let _e2288 = global_4.member[bitcast<u32>(select(0i, _e2282, (_e2282 > 0i)))];
let _e2303 = ((_e2032 + (f32(bitcast<i32>((_e2288 >> bitcast<u32>(12u)))) * _e2041)) + ((f32((bitcast<i32>((_e2288 & 4095u)) - 2048i)) * _e2022) * (_e2264 - f32(_e2279))));
let _e2304 = (_e2143 - _e2103);
let _e2306 = (_e2223 - _e2183);
let _e2308 = (_e2303 - _e2263);
phi_4744_ = type_28(_e2047, vec3<f32>((0.5f * _e2304), (0.5f * _e2306), (0.5f * _e2308)), vec3<f32>((0.25f * (_e2304 * (_e2143 + _e2103))), (0.25f * (_e2306 * (_e2223 + _e2183))), (0.25f * (_e2308 * (_e2303 + _e2263)))));
}
let _e2323 = phi_4744_;
let _e2338 = select(0f, 1f, ((((((_e958 >= -0.5f) && (_e958 <= _e1275)) && (_e973 >= -0.5f)) && (_e973 <= _e1285)) && (_e988 >= -0.5f)) && (_e988 <= _e1295)));
let _e2340 = (0.5f * (_e1953 - _e1947));
let _e2342 = (0.5f * (_e1965 - _e1959));
let _e2344 = (0.5f * (_e1977 - _e1971));
let _e2350 = global_1.member.member_7.member.member.member;
let _e2356 = global_1.member.member_7.member.member.member_1;
let _e2362 = global_1.member.member_7.member.member.member_2;
let _e2368 = global_1.member.member_7.member_1.member.member;
let _e2374 = global_1.member.member_7.member_1.member.member_1;
let _e2380 = global_1.member.member_7.member_1.member.member_2;
let _e2386 = global_1.member.member_7.member_2.member.member;
let _e2392 = global_1.member.member_7.member_2.member.member_1;
let _e2398 = global_1.member.member_7.member_2.member.member_2;
phi_5390_ = type_29(select(1f, _e1267, (_e1267 < 1f)), vec3<f32>(((((_e2350 * _e2340) + (_e2368 * _e2342)) + (_e2386 * _e2344)) * _e2338), ((((_e2356 * _e2340) + (_e2374 * _e2342)) + (_e2392 * _e2344)) * _e2338), ((((_e2362 * _e2340) + (_e2380 * _e2342)) + (_e2398 * _e2344)) * _e2338)), _e2323.member, vec3<f32>(((((_e2350 * _e2323.member_2.x) + (_e2368 * _e2323.member_2.y)) + (_e2386 * _e2323.member_2.z)) * _e2338), ((((_e2356 * _e2323.member_2.x) + (_e2374 * _e2323.member_2.y)) + (_e2392 * _e2323.member_2.z)) * _e2338), ((((_e2362 * _e2323.member_2.x) + (_e2380 * _e2323.member_2.y)) + (_e2398 * _e2323.member_2.z)) * _e2338)), vec3<f32>(((((_e2350 * _e2323.member_1.x) + (_e2368 * _e2323.member_1.y)) + (_e2386 * _e2323.member_1.z)) * _e2338), ((((_e2356 * _e2323.member_1.x) + (_e2374 * _e2323.member_1.y)) + (_e2392 * _e2323.member_1.z)) * _e2338), ((((_e2362 * _e2323.member_1.x) + (_e2380 * _e2323.member_1.y)) + (_e2398 * _e2323.member_1.z)) * _e2338)));
} else {
let _e2467 = global_1.member.member_6.member_3.member;
let _e2468 = (_e2467 - 0.5f);
let _e2470 = select(-0.5f, _e931, (_e931 > -0.5f));
let _e2472 = select(_e2468, _e2470, (_e2470 < _e2468));
let _e2477 = global_1.member.member_6.member_3.member_1;
let _e2478 = (_e2477 - 0.5f);
let _e2480 = select(-0.5f, _e937, (_e937 > -0.5f));
let _e2482 = select(_e2478, _e2480, (_e2480 < _e2478));
let _e2487 = global_1.member.member_6.member_3.member_2;
let _e2488 = (_e2487 - 0.5f);
let _e2490 = select(-0.5f, _e943, (_e943 > -0.5f));
let _e2492 = select(_e2488, _e2490, (_e2490 < _e2488));
let _e2494 = select(-1f, _e2472, (_e2472 > -1f));
let _e2496 = select(_e2467, _e2494, (_e2494 < _e2467));
let _e2503 = select(0i, select(select(i32(_e2496), i32(-2147483648), (_e2496 < -2147483600f)), 2147483647i, (_e2496 > 2147483500f)), (_e2496 == _e2496));
let _e2507 = (_e2503 - select(0i, 1i, (_e2496 < f32(_e2503))));
let _e2509 = select(-1f, _e2482, (_e2482 > -1f));
let _e2511 = select(_e2477, _e2509, (_e2509 < _e2477));
let _e2518 = select(0i, select(select(i32(_e2511), i32(-2147483648), (_e2511 < -2147483600f)), 2147483647i, (_e2511 > 2147483500f)), (_e2511 == _e2511));
let _e2522 = (_e2518 - select(0i, 1i, (_e2511 < f32(_e2518))));
let _e2524 = select(-1f, _e2492, (_e2492 > -1f));
let _e2526 = select(_e2487, _e2524, (_e2524 < _e2487));
let _e2533 = select(0i, select(select(i32(_e2526), i32(-2147483648), (_e2526 < -2147483600f)), 2147483647i, (_e2526 > 2147483500f)), (_e2526 == _e2526));
let _e2537 = (_e2533 - select(0i, 1i, (_e2526 < f32(_e2533))));
let _e2541 = global_1.member.member_6.member_7;
let _e2545 = global_1.member.member_6.member_8;
let _e2553 = (select(0i, select(select(i32(_e2477), i32(-2147483648), (_e2477 < -2147483600f)), 2147483647i, (_e2477 > 2147483500f)), (_e2477 == _e2477)) - 1i);
let _e2556 = (_e2522 + 1i);
let _e2566 = (select(0i, select(select(i32(_e2487), i32(-2147483648), (_e2487 < -2147483600f)), 2147483647i, (_e2487 > 2147483500f)), (_e2487 == _e2487)) - 1i);
let _e2569 = (_e2537 + 1i);
let _e2579 = (select(0i, select(select(i32(_e2467), i32(-2147483648), (_e2467 < -2147483600f)), 2147483647i, (_e2467 > 2147483500f)), (_e2467 == _e2467)) - 1i);
let _e2580 = (_e2507 - 1i);
let _e2585 = (_e2507 + 1i);
let _e2588 = (_e2507 + 2i);
let _e2591 = (select(0i, _e2522, (_e2522 > 0i)) * _e2541);
let _e2592 = (select(_e2553, _e2556, (_e2556 < _e2553)) * _e2541);
let _e2593 = (select(0i, _e2537, (_e2537 > 0i)) * _e2545);
let _e2594 = (select(_e2566, _e2569, (_e2569 < _e2566)) * _e2545);
local_2 = type_27(array<i32, 4>(select(0i, _e2580, (_e2580 > 0i)), select(0i, _e2507, (_e2507 > 0i)), select(_e2579, _e2585, (_e2585 < _e2579)), select(_e2579, _e2588, (_e2588 < _e2579))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_3 = vec3<f32>((_e2472 - f32(_e2507)), (_e2482 - f32(_e2522)), (_e2492 - f32(_e2537)));
let _e2605 = (_e2593 + _e2591);
let _e2608 = local_2.member[1u];
let _e2609 = (_e2605 + _e2608);
let _e2611 = (bitcast<i32>(_e88) - 1i);
let _e2613 = select(_e2611, _e2609, (_e2609 < _e2611));
let _e2618 = global_2.member[bitcast<u32>(select(0i, _e2613, (_e2613 > 0i)))];
let _e2619 = bitcast<f32>(_e2618);
let _e2622 = local_2.member[2u];
let _e2623 = (_e2605 + _e2622);
let _e2625 = select(_e2611, _e2623, (_e2623 < _e2611));
let _e2630 = global_2.member[bitcast<u32>(select(0i, _e2625, (_e2625 > 0i)))];
let _e2632 = local_3[0u];
let _e2635 = (_e2619 + ((bitcast<f32>(_e2630) - _e2619) * _e2632));
let _e2636 = (_e2593 + _e2592);
let _e2637 = local_2.member[1u];
let _e2638 = (_e2636 + _e2637);
let _e2640 = select(_e2611, _e2638, (_e2638 < _e2611));
let _e2645 = global_2.member[bitcast<u32>(select(0i, _e2640, (_e2640 > 0i)))];
let _e2646 = bitcast<f32>(_e2645);
let _e2647 = local_2.member[2u];
let _e2648 = (_e2636 + _e2647);
let _e2650 = select(_e2611, _e2648, (_e2648 < _e2611));
let _e2655 = global_2.member[bitcast<u32>(select(0i, _e2650, (_e2650 > 0i)))];
let _e2657 = local_3[0u];
let _e2662 = local_3[1u];
let _e2665 = (_e2635 + (((_e2646 + ((bitcast<f32>(_e2655) - _e2646) * _e2657)) - _e2635) * _e2662));
let _e2666 = (_e2594 + _e2591);
let _e2667 = local_2.member[1u];
let _e2668 = (_e2666 + _e2667);
let _e2670 = select(_e2611, _e2668, (_e2668 < _e2611));
let _e2675 = global_2.member[bitcast<u32>(select(0i, _e2670, (_e2670 > 0i)))];
let _e2676 = bitcast<f32>(_e2675);
let _e2677 = local_2.member[2u];
let _e2678 = (_e2666 + _e2677);
let _e2680 = select(_e2611, _e2678, (_e2678 < _e2611));
let _e2685 = global_2.member[bitcast<u32>(select(0i, _e2680, (_e2680 > 0i)))];
let _e2687 = local_3[0u];
let _e2690 = (_e2676 + ((bitcast<f32>(_e2685) - _e2676) * _e2687));
let _e2691 = (_e2594 + _e2592);
let _e2692 = local_2.member[1u];
let _e2693 = (_e2691 + _e2692);
let _e2695 = select(_e2611, _e2693, (_e2693 < _e2611));
let _e2700 = global_2.member[bitcast<u32>(select(0i, _e2695, (_e2695 > 0i)))];
let _e2701 = bitcast<f32>(_e2700);
let _e2702 = local_2.member[2u];
let _e2703 = (_e2691 + _e2702);
let _e2705 = select(_e2611, _e2703, (_e2703 < _e2611));
let _e2710 = global_2.member[bitcast<u32>(select(0i, _e2705, (_e2705 > 0i)))];
let _e2712 = local_3[0u];
let _e2716 = local_3[1u];
let _e2721 = local_3[2u];
let _e2728 = global_1.member.member_6.member_5;
let _e2733 = global_1.member.member_6.member_6;
let _e2734 = (((_e2665 + (((_e2690 + (((_e2701 + ((bitcast<f32>(_e2710) - _e2701) * _e2712)) - _e2690) * _e2716)) - _e2665) * _e2721)) * _e2728) + _e2733);
let _e2736 = select(0f, _e2734, (_e2734 > 0f));
phi_5390_ = type_29(select(1f, _e2736, (_e2736 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2741 = phi_5390_;
let _e2746 = global_1.member.member_6.member_3.member;
let _e2747 = (_e2746 - 0.5f);
let _e2749 = select(-0.5f, _e895, (_e895 > -0.5f));
let _e2751 = select(_e2747, _e2749, (_e2749 < _e2747));
let _e2756 = global_1.member.member_6.member_3.member_1;
let _e2757 = (_e2756 - 0.5f);
let _e2759 = select(-0.5f, _e910, (_e910 > -0.5f));
let _e2761 = select(_e2757, _e2759, (_e2759 < _e2757));
let _e2766 = global_1.member.member_6.member_3.member_2;
let _e2767 = (_e2766 - 0.5f);
let _e2769 = select(-0.5f, _e925, (_e925 > -0.5f));
let _e2771 = select(_e2767, _e2769, (_e2769 < _e2767));
let _e2773 = select(-1f, _e2751, (_e2751 > -1f));
let _e2775 = select(_e2746, _e2773, (_e2773 < _e2746));
let _e2782 = select(0i, select(select(i32(_e2775), i32(-2147483648), (_e2775 < -2147483600f)), 2147483647i, (_e2775 > 2147483500f)), (_e2775 == _e2775));
let _e2786 = (_e2782 - select(0i, 1i, (_e2775 < f32(_e2782))));
let _e2788 = select(-1f, _e2761, (_e2761 > -1f));
let _e2790 = select(_e2756, _e2788, (_e2788 < _e2756));
let _e2797 = select(0i, select(select(i32(_e2790), i32(-2147483648), (_e2790 < -2147483600f)), 2147483647i, (_e2790 > 2147483500f)), (_e2790 == _e2790));
let _e2801 = (_e2797 - select(0i, 1i, (_e2790 < f32(_e2797))));
let _e2803 = select(-1f, _e2771, (_e2771 > -1f));
let _e2805 = select(_e2766, _e2803, (_e2803 < _e2766));
let _e2812 = select(0i, select(select(i32(_e2805), i32(-2147483648), (_e2805 < -2147483600f)), 2147483647i, (_e2805 > 2147483500f)), (_e2805 == _e2805));
let _e2816 = (_e2812 - select(0i, 1i, (_e2805 < f32(_e2812))));
let _e2820 = global_1.member.member_6.member_7;
let _e2824 = global_1.member.member_6.member_8;
let _e2832 = (select(0i, select(select(i32(_e2756), i32(-2147483648), (_e2756 < -2147483600f)), 2147483647i, (_e2756 > 2147483500f)), (_e2756 == _e2756)) - 1i);
let _e2835 = (_e2801 + 1i);
let _e2845 = (select(0i, select(select(i32(_e2766), i32(-2147483648), (_e2766 < -2147483600f)), 2147483647i, (_e2766 > 2147483500f)), (_e2766 == _e2766)) - 1i);
let _e2848 = (_e2816 + 1i);
let _e2858 = (select(0i, select(select(i32(_e2746), i32(-2147483648), (_e2746 < -2147483600f)), 2147483647i, (_e2746 > 2147483500f)), (_e2746 == _e2746)) - 1i);
let _e2859 = (_e2786 - 1i);
let _e2864 = (_e2786 + 1i);
let _e2867 = (_e2786 + 2i);
let _e2870 = (select(0i, _e2801, (_e2801 > 0i)) * _e2820);
let _e2871 = (select(_e2832, _e2835, (_e2835 < _e2832)) * _e2820);
let _e2872 = (select(0i, _e2816, (_e2816 > 0i)) * _e2824);
let _e2873 = (select(_e2845, _e2848, (_e2848 < _e2845)) * _e2824);
local = type_27(array<i32, 4>(select(0i, _e2859, (_e2859 > 0i)), select(0i, _e2786, (_e2786 > 0i)), select(_e2858, _e2864, (_e2864 < _e2858)), select(_e2858, _e2867, (_e2867 < _e2858))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_1 = vec3<f32>((_e2751 - f32(_e2786)), (_e2761 - f32(_e2801)), (_e2771 - f32(_e2816)));
let _e2884 = (_e2872 + _e2870);
let _e2887 = local.member[1u];
let _e2888 = (_e2884 + _e2887);
let _e2890 = (bitcast<i32>(_e88) - 1i);
let _e2892 = select(_e2890, _e2888, (_e2888 < _e2890));
let _e2897 = global_2.member[bitcast<u32>(select(0i, _e2892, (_e2892 > 0i)))];
let _e2898 = bitcast<f32>(_e2897);
let _e2901 = local.member[2u];
let _e2902 = (_e2884 + _e2901);
let _e2904 = select(_e2890, _e2902, (_e2902 < _e2890));
let _e2909 = global_2.member[bitcast<u32>(select(0i, _e2904, (_e2904 > 0i)))];
let _e2911 = local_1[0u];
let _e2914 = (_e2898 + ((bitcast<f32>(_e2909) - _e2898) * _e2911));
let _e2915 = (_e2872 + _e2871);
let _e2916 = local.member[1u];
let _e2917 = (_e2915 + _e2916);
let _e2919 = select(_e2890, _e2917, (_e2917 < _e2890));
let _e2924 = global_2.member[bitcast<u32>(select(0i, _e2919, (_e2919 > 0i)))];
let _e2925 = bitcast<f32>(_e2924);
let _e2926 = local.member[2u];
let _e2927 = (_e2915 + _e2926);
let _e2929 = select(_e2890, _e2927, (_e2927 < _e2890));
let _e2934 = global_2.member[bitcast<u32>(select(0i, _e2929, (_e2929 > 0i)))];
let _e2936 = local_1[0u];
let _e2941 = local_1[1u];
let _e2944 = (_e2914 + (((_e2925 + ((bitcast<f32>(_e2934) - _e2925) * _e2936)) - _e2914) * _e2941));
let _e2945 = (_e2873 + _e2870);
let _e2946 = local.member[1u];
let _e2947 = (_e2945 + _e2946);
let _e2949 = select(_e2890, _e2947, (_e2947 < _e2890));
let _e2954 = global_2.member[bitcast<u32>(select(0i, _e2949, (_e2949 > 0i)))];
let _e2955 = bitcast<f32>(_e2954);
let _e2956 = local.member[2u];
let _e2957 = (_e2945 + _e2956);
let _e2959 = select(_e2890, _e2957, (_e2957 < _e2890));
let _e2964 = global_2.member[bitcast<u32>(select(0i, _e2959, (_e2959 > 0i)))];
let _e2966 = local_1[0u];
let _e2969 = (_e2955 + ((bitcast<f32>(_e2964) - _e2955) * _e2966));
let _e2970 = (_e2873 + _e2871);
let _e2971 = local.member[1u];
let _e2972 = (_e2970 + _e2971);
let _e2974 = select(_e2890, _e2972, (_e2972 < _e2890));
let _e2979 = global_2.member[bitcast<u32>(select(0i, _e2974, (_e2974 > 0i)))];
let _e2980 = bitcast<f32>(_e2979);
let _e2981 = local.member[2u];
let _e2982 = (_e2970 + _e2981);
let _e2984 = select(_e2890, _e2982, (_e2982 < _e2890));
let _e2989 = global_2.member[bitcast<u32>(select(0i, _e2984, (_e2984 > 0i)))];
let _e2991 = local_1[0u];
let _e2995 = local_1[1u];
let _e3000 = local_1[2u];
let _e3007 = global_1.member.member_6.member_5;
let _e3012 = global_1.member.member_6.member_6;
let _e3013 = (((_e2944 + (((_e2969 + (((_e2980 + ((bitcast<f32>(_e2989) - _e2980) * _e2991)) - _e2969) * _e2995)) - _e2944) * _e3000)) * _e3007) + _e3012);
let _e3015 = select(0f, _e3013, (_e3013 > 0f));
let _e3017 = select(1f, _e3015, (_e3015 < 1f));
let _e3020 = global_1.member.member_1;
if ((_e3020 & 16u) == 0u) {
phi_6223_ = type_5(1f, 1f, 1f);
} else {
let _e3026 = global_1.member.member_14.member;
let _e3037 = ((((_e3026.member.member * _e852) + (_e3026.member.member_1 * _e865)) + (_e3026.member.member_2 * _e830)) + _e3026.member_1);
let _e3043 = ((((_e3026.member.member * _e875) + (_e3026.member.member_1 * _e880)) + (_e3026.member.member_2 * _e869)) + _e3026.member_1);
let _e3045 = select(_e3043, _e3037, (_e3037 < _e3043));
let _e3047 = select(_e3043, _e3037, (_e3037 > _e3043));
let _e3049 = (_e3047 - _e3045);
let _e3052 = (-(_e3045) / select(1e-30f, _e3049, (_e3049 > 1e-30f)));
let _e3054 = select(0f, _e3052, (_e3052 > 0f));
let _e3060 = select(select(select(1f, _e3054, (_e3054 < 1f)), 1f, (_e3047 <= 0f)), 0f, (_e3045 > 0f));
let _e3065 = global_1.member.member_14.member_1;
let _e3066 = (_e3065 != 0u);
let _e3076 = global_1.member.member_15.member;
let _e3087 = ((((_e3076.member.member * _e852) + (_e3076.member.member_1 * _e865)) + (_e3076.member.member_2 * _e830)) + _e3076.member_1);
let _e3093 = ((((_e3076.member.member * _e875) + (_e3076.member.member_1 * _e880)) + (_e3076.member.member_2 * _e869)) + _e3076.member_1);
let _e3095 = select(_e3093, _e3087, (_e3087 < _e3093));
let _e3097 = select(_e3093, _e3087, (_e3087 > _e3093));
let _e3099 = (_e3097 - _e3095);
let _e3102 = (-(_e3095) / select(1e-30f, _e3099, (_e3099 > 1e-30f)));
let _e3104 = select(0f, _e3102, (_e3102 > 0f));
let _e3110 = select(select(select(1f, _e3104, (_e3104 < 1f)), 1f, (_e3097 <= 0f)), 0f, (_e3095 > 0f));
let _e3115 = global_1.member.member_15.member_1;
let _e3116 = (_e3115 != 0u);
let _e3126 = global_1.member.member_16.member;
let _e3137 = ((((_e3126.member.member * _e852) + (_e3126.member.member_1 * _e865)) + (_e3126.member.member_2 * _e830)) + _e3126.member_1);
let _e3143 = ((((_e3126.member.member * _e875) + (_e3126.member.member_1 * _e880)) + (_e3126.member.member_2 * _e869)) + _e3126.member_1);
let _e3145 = select(_e3143, _e3137, (_e3137 < _e3143));
let _e3147 = select(_e3143, _e3137, (_e3137 > _e3143));
let _e3149 = (_e3147 - _e3145);
let _e3152 = (-(_e3145) / select(1e-30f, _e3149, (_e3149 > 1e-30f)));
let _e3154 = select(0f, _e3152, (_e3152 > 0f));
let _e3160 = select(select(select(1f, _e3154, (_e3154 < 1f)), 1f, (_e3147 <= 0f)), 0f, (_e3145 > 0f));
let _e3165 = global_1.member.member_16.member_1;
let _e3166 = (_e3165 != 0u);
let _e3176 = global_1.member.member_17.member;
let _e3187 = ((((_e3176.member.member * _e852) + (_e3176.member.member_1 * _e865)) + (_e3176.member.member_2 * _e830)) + _e3176.member_1);
let _e3193 = ((((_e3176.member.member * _e875) + (_e3176.member.member_1 * _e880)) + (_e3176.member.member_2 * _e869)) + _e3176.member_1);
let _e3195 = select(_e3193, _e3187, (_e3187 < _e3193));
let _e3197 = select(_e3193, _e3187, (_e3187 > _e3193));
let _e3199 = (_e3197 - _e3195);
let _e3202 = (-(_e3195) / select(1e-30f, _e3199, (_e3199 > 1e-30f)));
let _e3204 = select(0f, _e3202, (_e3202 > 0f));
let _e3210 = select(select(select(1f, _e3204, (_e3204 < 1f)), 1f, (_e3197 <= 0f)), 0f, (_e3195 > 0f));
let _e3215 = global_1.member.member_17.member_1;
let _e3216 = (_e3215 != 0u);
phi_6223_ = type_5(((((1f * _e3060) * _e3110) * _e3160) * _e3210), ((((1f * select(1f, _e3060, _e3066)) * select(1f, _e3110, _e3116)) * select(1f, _e3160, _e3166)) * select(1f, _e3210, _e3216)), ((((1f * select(1f, 0f, (_e3066 && (_e3043 > 0f)))) * select(1f, 0f, (_e3116 && (_e3093 > 0f)))) * select(1f, 0f, (_e3166 && (_e3143 > 0f)))) * select(1f, 0f, (_e3216 && (_e3193 > 0f)))));
}
let _e3225 = phi_6223_;
let _e3226 = (_e931 - _e895);
let _e3230 = (bitcast<f32>((bitcast<u32>(_e3226) & 2147483647u)) < 1e-12f);
let _e3232 = (1f / select(_e3226, 1f, _e3230));
let _e3234 = ((-0.5f - _e895) * _e3232);
let _e3236 = ((_e2747 - _e895) * _e3232);
let _e3242 = select(_e3236, _e3234, (_e3234 < _e3236));
let _e3244 = select(0f, _e3242, (_e3242 > 0f));
let _e3247 = select(select(1f, _e3244, (_e3244 < 1f)), select(2f, 0f, ((_e895 >= -0.5f) && (_e895 <= _e2747))), _e3230);
let _e3249 = select(_e3236, _e3234, (_e3234 > _e3236));
let _e3251 = select(0f, _e3249, (_e3249 > 0f));
let _e3254 = select(select(1f, _e3251, (_e3251 < 1f)), 1f, _e3230);
let _e3255 = (_e937 - _e910);
let _e3259 = (bitcast<f32>((bitcast<u32>(_e3255) & 2147483647u)) < 1e-12f);
let _e3261 = (1f / select(_e3255, 1f, _e3259));
let _e3263 = ((-0.5f - _e910) * _e3261);
let _e3265 = ((_e2757 - _e910) * _e3261);
let _e3271 = select(_e3265, _e3263, (_e3263 < _e3265));
let _e3273 = select(0f, _e3271, (_e3271 > 0f));
let _e3276 = select(select(1f, _e3273, (_e3273 < 1f)), select(2f, 0f, ((_e910 >= -0.5f) && (_e910 <= _e2757))), _e3259);
let _e3278 = select(_e3265, _e3263, (_e3263 > _e3265));
let _e3280 = select(0f, _e3278, (_e3278 > 0f));
let _e3283 = select(select(1f, _e3280, (_e3280 < 1f)), 1f, _e3259);
let _e3284 = (_e943 - _e925);
let _e3288 = (bitcast<f32>((bitcast<u32>(_e3284) & 2147483647u)) < 1e-12f);
let _e3290 = (1f / select(_e3284, 1f, _e3288));
let _e3292 = ((-0.5f - _e925) * _e3290);
let _e3294 = ((_e2767 - _e925) * _e3290);
let _e3300 = select(_e3294, _e3292, (_e3292 < _e3294));
let _e3302 = select(0f, _e3300, (_e3300 > 0f));
let _e3305 = select(select(1f, _e3302, (_e3302 < 1f)), select(2f, 0f, ((_e925 >= -0.5f) && (_e925 <= _e2767))), _e3288);
let _e3307 = select(_e3294, _e3292, (_e3292 > _e3294));
let _e3309 = select(0f, _e3307, (_e3307 > 0f));
let _e3312 = select(select(1f, _e3309, (_e3309 < 1f)), 1f, _e3288);
let _e3314 = select(_e3283, _e3254, (_e3254 < _e3283));
let _e3318 = select(_e3276, _e3247, (_e3247 > _e3276));
let _e3321 = (select(_e3312, _e3314, (_e3314 < _e3312)) - select(_e3305, _e3318, (_e3318 > _e3305)));
let _e3324 = (_e875 - _e852);
let _e3325 = (_e880 - _e865);
let _e3326 = (_e869 - _e830);
let _e3331 = (((_e3324 * _e3324) + (_e3325 * _e3325)) + (_e3326 * _e3326));
let _e3339 = global_1.member.member_5.member_3;
let _e3340 = ((sqrt(select(0f, _e3331, (_e3331 > 0f))) * select(0f, _e3321, (_e3321 > 0f))) * _e3339);
if (_e105.member_2 >= 3u) {
let _e3343 = (_e3017 * 255f);
let _e3344 = (_e2741.member * 255f);
let _e3345 = (255f - 1f);
let _e3347 = select(0f, _e3343, (_e3343 > 0f));
let _e3349 = select(_e3345, _e3347, (_e3347 < _e3345));
let _e3356 = select(0i, select(select(i32(_e3349), i32(-2147483648), (_e3349 < -2147483600f)), 2147483647i, (_e3349 > 2147483500f)), (_e3349 == _e3349));
let _e3360 = (_e3356 - select(0i, 1i, (_e3349 < f32(_e3356))));
let _e3362 = select(0f, _e3344, (_e3344 > 0f));
let _e3364 = select(_e3345, _e3362, (_e3362 < _e3345));
let _e3371 = select(0i, select(select(i32(_e3364), i32(-2147483648), (_e3364 < -2147483600f)), 2147483647i, (_e3364 > 2147483500f)), (_e3364 == _e3364));
let _e3375 = (_e3371 - select(0i, 1i, (_e3364 < f32(_e3371))));
let _e3378 = (((_e3360 * 256i) + _e3375) * 4i);
let _e3382 = (_e3344 - f32(_e3375));
let _e3384 = (bitcast<i32>(_e95) - 1i);
let _e3386 = select(_e3384, _e3378, (_e3378 < _e3384));
let _e3392 = global_4.member[bitcast<u32>(select(0i, _e3386, (_e3386 > 0i)))];
let _e3393 = (_e3378 + 4i);
let _e3395 = select(_e3384, _e3393, (_e3393 < _e3384));
let _e3401 = global_4.member[bitcast<u32>(select(0i, _e3395, (_e3395 > 0i)))];
let _e3402 = (_e3378 + 1024i);
let _e3404 = select(_e3384, _e3402, (_e3402 < _e3384));
let _e3410 = global_4.member[bitcast<u32>(select(0i, _e3404, (_e3404 > 0i)))];
let _e3411 = (_e3378 + 1028i);
let _e3413 = select(_e3384, _e3411, (_e3411 < _e3384));
let _e3419 = global_4.member[bitcast<u32>(select(0i, _e3413, (_e3413 > 0i)))];
let _e3424 = (bitcast<f32>(((_e3392 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3432 = (_e3424 + (((bitcast<f32>(((_e3401 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3424) * _e3382));
let _e3437 = (bitcast<f32>(((_e3410 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3448 = (_e3432 + (((_e3437 + (((bitcast<f32>(((_e3419 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3437) * _e3382)) - _e3432) * (_e3343 - f32(_e3360))));
let _e3452 = -((_e3448 * (_e3340 * _e3225.member)));
let _e3454 = select(-87f, _e3452, (_e3452 > -87f));
let _e3456 = select(88f, _e3454, (_e3454 < 88f));
let _e3458 = ((_e3456 * 1.442695f) + 0.5f);
let _e3460 = select(-127f, _e3458, (_e3458 > -127f));
let _e3462 = select(128f, _e3460, (_e3460 < 128f));
let _e3469 = select(0i, select(select(i32(_e3462), i32(-2147483648), (_e3462 < -2147483600f)), 2147483647i, (_e3462 > 2147483500f)), (_e3462 == _e3462));
let _e3473 = (_e3469 - select(0i, 1i, (_e3462 < f32(_e3469))));
let _e3474 = f32(_e3473);
let _e3478 = ((_e3456 - (_e3474 * 0.6933594f)) - (_e3474 * -2.1219444e-4f));
let _e3498 = ((1f + (_e3478 * (1f + (_e3478 * (0.5f + (_e3478 * (0.16666667f + (_e3478 * (0.041666668f + (_e3478 * (0.008333334f + (_e3478 * (0.001388889f + (_e3478 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3473 + 127i)) << bitcast<u32>(23i))));
let _e3499 = (1f - _e3498);
phi_7333_ = type_30(_e3498, _e3499, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e3499 / select(1e-12f, _e3448, (_e3448 > 1e-12f))))));
} else {
let _e3507 = (_e3017 * 255f);
let _e3508 = (_e2741.member * 255f);
let _e3509 = (255f - 1f);
let _e3511 = select(0f, _e3507, (_e3507 > 0f));
let _e3513 = select(_e3509, _e3511, (_e3511 < _e3509));
let _e3520 = select(0i, select(select(i32(_e3513), i32(-2147483648), (_e3513 < -2147483600f)), 2147483647i, (_e3513 > 2147483500f)), (_e3513 == _e3513));
let _e3524 = (_e3520 - select(0i, 1i, (_e3513 < f32(_e3520))));
let _e3526 = select(0f, _e3508, (_e3508 > 0f));
let _e3528 = select(_e3509, _e3526, (_e3526 < _e3509));
let _e3535 = select(0i, select(select(i32(_e3528), i32(-2147483648), (_e3528 < -2147483600f)), 2147483647i, (_e3528 > 2147483500f)), (_e3528 == _e3528));
let _e3539 = (_e3535 - select(0i, 1i, (_e3528 < f32(_e3535))));
let _e3542 = (((_e3524 * 256i) + _e3539) * 4i);
let _e3544 = (_e3507 - f32(_e3524));
let _e3546 = (_e3508 - f32(_e3539));
let _e3548 = (bitcast<i32>(_e95) - 1i);
let _e3550 = select(_e3548, _e3542, (_e3542 < _e3548));
let _e3556 = global_4.member[bitcast<u32>(select(0i, _e3550, (_e3550 > 0i)))];
let _e3557 = (_e3542 + 4i);
let _e3559 = select(_e3548, _e3557, (_e3557 < _e3548));
let _e3565 = global_4.member[bitcast<u32>(select(0i, _e3559, (_e3559 > 0i)))];
let _e3566 = (_e3542 + 1024i);
let _e3568 = select(_e3548, _e3566, (_e3566 < _e3548));
let _e3574 = global_4.member[bitcast<u32>(select(0i, _e3568, (_e3568 > 0i)))];
let _e3575 = (_e3542 + 1028i);
let _e3577 = select(_e3548, _e3575, (_e3575 < _e3548));
let _e3583 = global_4.member[bitcast<u32>(select(0i, _e3577, (_e3577 > 0i)))];
let _e3588 = (bitcast<f32>(((_e3556 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3596 = (_e3588 + (((bitcast<f32>(((_e3565 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3588) * _e3546));
let _e3601 = (bitcast<f32>(((_e3574 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3612 = (_e3596 + (((_e3601 + (((bitcast<f32>(((_e3583 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3601) * _e3546)) - _e3596) * _e3544));
let _e3625 = (bitcast<f32>((((_e3556 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3633 = (_e3625 + (((bitcast<f32>((((_e3565 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3625) * _e3546));
let _e3638 = (bitcast<f32>((((_e3574 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3650 = (_e3542 + 1i);
let _e3652 = select(_e3548, _e3650, (_e3650 < _e3548));
let _e3658 = global_4.member[bitcast<u32>(select(0i, _e3652, (_e3652 > 0i)))];
let _e3659 = (_e3542 + 5i);
let _e3661 = select(_e3548, _e3659, (_e3659 < _e3548));
let _e3667 = global_4.member[bitcast<u32>(select(0i, _e3661, (_e3661 > 0i)))];
let _e3668 = (_e3542 + 1025i);
let _e3670 = select(_e3548, _e3668, (_e3668 < _e3548));
let _e3676 = global_4.member[bitcast<u32>(select(0i, _e3670, (_e3670 > 0i)))];
let _e3677 = (_e3542 + 1029i);
let _e3679 = select(_e3548, _e3677, (_e3677 < _e3548));
let _e3685 = global_4.member[bitcast<u32>(select(0i, _e3679, (_e3679 > 0i)))];
let _e3690 = (bitcast<f32>(((_e3658 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3698 = (_e3690 + (((bitcast<f32>(((_e3667 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3690) * _e3546));
let _e3703 = (bitcast<f32>(((_e3676 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3727 = (bitcast<f32>((((_e3658 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3735 = (_e3727 + (((bitcast<f32>((((_e3667 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3727) * _e3546));
let _e3740 = (bitcast<f32>((((_e3676 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3755 = (_e3340 * _e3225.member_1);
let _e3757 = -(((_e3633 + (((_e3638 + (((bitcast<f32>((((_e3583 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3638) * _e3546)) - _e3633) * _e3544)) * _e3755));
let _e3759 = select(-87f, _e3757, (_e3757 > -87f));
let _e3761 = select(88f, _e3759, (_e3759 < 88f));
let _e3763 = ((_e3761 * 1.442695f) + 0.5f);
let _e3765 = select(-127f, _e3763, (_e3763 > -127f));
let _e3767 = select(128f, _e3765, (_e3765 < 128f));
let _e3774 = select(0i, select(select(i32(_e3767), i32(-2147483648), (_e3767 < -2147483600f)), 2147483647i, (_e3767 > 2147483500f)), (_e3767 == _e3767));
let _e3778 = (_e3774 - select(0i, 1i, (_e3767 < f32(_e3774))));
let _e3779 = f32(_e3778);
let _e3783 = ((_e3761 - (_e3779 * 0.6933594f)) - (_e3779 * -2.1219444e-4f));
let _e3805 = -(((_e3698 + (((_e3703 + (((bitcast<f32>(((_e3685 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3703) * _e3546)) - _e3698) * _e3544)) * _e3755));
let _e3807 = select(-87f, _e3805, (_e3805 > -87f));
let _e3809 = select(88f, _e3807, (_e3807 < 88f));
let _e3811 = ((_e3809 * 1.442695f) + 0.5f);
let _e3813 = select(-127f, _e3811, (_e3811 > -127f));
let _e3815 = select(128f, _e3813, (_e3813 < 128f));
let _e3822 = select(0i, select(select(i32(_e3815), i32(-2147483648), (_e3815 < -2147483600f)), 2147483647i, (_e3815 > 2147483500f)), (_e3815 == _e3815));
let _e3826 = (_e3822 - select(0i, 1i, (_e3815 < f32(_e3822))));
let _e3827 = f32(_e3826);
let _e3831 = ((_e3809 - (_e3827 * 0.6933594f)) - (_e3827 * -2.1219444e-4f));
let _e3853 = -(((_e3735 + (((_e3740 + (((bitcast<f32>((((_e3685 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3740) * _e3546)) - _e3735) * _e3544)) * _e3755));
let _e3855 = select(-87f, _e3853, (_e3853 > -87f));
let _e3857 = select(88f, _e3855, (_e3855 < 88f));
let _e3859 = ((_e3857 * 1.442695f) + 0.5f);
let _e3861 = select(-127f, _e3859, (_e3859 > -127f));
let _e3863 = select(128f, _e3861, (_e3861 < 128f));
let _e3870 = select(0i, select(select(i32(_e3863), i32(-2147483648), (_e3863 < -2147483600f)), 2147483647i, (_e3863 > 2147483500f)), (_e3863 == _e3863));
let _e3874 = (_e3870 - select(0i, 1i, (_e3863 < f32(_e3870))));
let _e3875 = f32(_e3874);
let _e3879 = ((_e3857 - (_e3875 * 0.6933594f)) - (_e3875 * -2.1219444e-4f));
let _e3902 = -((_e3612 * (_e3340 * _e3225.member)));
let _e3904 = select(-87f, _e3902, (_e3902 > -87f));
let _e3906 = select(88f, _e3904, (_e3904 < 88f));
let _e3908 = ((_e3906 * 1.442695f) + 0.5f);
let _e3910 = select(-127f, _e3908, (_e3908 > -127f));
let _e3912 = select(128f, _e3910, (_e3910 < 128f));
let _e3919 = select(0i, select(select(i32(_e3912), i32(-2147483648), (_e3912 < -2147483600f)), 2147483647i, (_e3912 > 2147483500f)), (_e3912 == _e3912));
let _e3923 = (_e3919 - select(0i, 1i, (_e3912 < f32(_e3919))));
let _e3924 = f32(_e3923);
let _e3928 = ((_e3906 - (_e3924 * 0.6933594f)) - (_e3924 * -2.1219444e-4f));
let _e3948 = ((1f + (_e3928 * (1f + (_e3928 * (0.5f + (_e3928 * (0.16666667f + (_e3928 * (0.041666668f + (_e3928 * (0.008333334f + (_e3928 * (0.001388889f + (_e3928 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3923 + 127i)) << bitcast<u32>(23i))));
let _e3949 = (1f - _e3948);
phi_7333_ = type_30(_e3948, _e3949, vec3<f32>(((1f + (_e3783 * (1f + (_e3783 * (0.5f + (_e3783 * (0.16666667f + (_e3783 * (0.041666668f + (_e3783 * (0.008333334f + (_e3783 * (0.001388889f + (_e3783 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3778 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3831 * (1f + (_e3831 * (0.5f + (_e3831 * (0.16666667f + (_e3831 * (0.041666668f + (_e3831 * (0.008333334f + (_e3831 * (0.001388889f + (_e3831 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3826 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3879 * (1f + (_e3879 * (0.5f + (_e3879 * (0.16666667f + (_e3879 * (0.041666668f + (_e3879 * (0.008333334f + (_e3879 * (0.001388889f + (_e3879 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3874 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e3949 / select(1e-12f, _e3612, (_e3612 > 1e-12f))))));
}
let _e3957 = phi_7333_;
if _e993 {
let _e3961 = global_1.member.member_5.member_2;
let _e3969 = global_1.member.member_5.member_4;
let _e3972 = (_e2741.member_3.x * _e3225.member_2);
let _e3974 = (_e2741.member_3.y * _e3225.member_2);
let _e3976 = (_e2741.member_3.z * _e3225.member_2);
let _e3977 = (0.5f * (_e3961 / select(1e-6f, _e185, (_e185 > 1e-6f))));
let _e3981 = (_e163 + (_e3972 * _e3977));
let _e3982 = (_e174 + (_e3974 * _e3977));
let _e3983 = (_e185 + (_e3976 * _e3977));
let _e3985 = (2f * _e3961);
let _e3987 = ((_e3983 * _e3983) + (_e3985 * _e3976));
let _e3991 = (_e3983 + sqrt(select(0f, _e3987, (_e3987 > 0f))));
let _e3995 = (0.5f * (_e3985 / select(1e-6f, _e3991, (_e3991 > 1e-6f))));
let _e3999 = (_e3981 + (_e3972 * _e3995));
let _e4000 = (_e3982 + (_e3974 * _e3995));
let _e4001 = (_e3983 + (_e3976 * _e3995));
let _e4005 = (_e3969 * _e3969);
let _e4007 = (_e4001 * _e4001);
let _e4015 = (((_e3983 <= 0f) || (_e3987 <= 0f)) || ((_e4001 <= 0f) || (_e4007 <= (_e4005 * (((_e3999 * _e3999) + (_e4000 * _e4000)) + _e4007)))));
let _e4029 = (_e163 + ((_e2741.member_4.x * _e3225.member_2) * _e3961));
let _e4030 = (_e174 + ((_e2741.member_4.y * _e3225.member_2) * _e3961));
let _e4031 = (_e185 + ((_e2741.member_4.z * _e3225.member_2) * _e3961));
let _e4033 = (_e4031 * _e4031);
let _e4042 = ((_e3020 & 1u) != 0u);
let _e4046 = select(_e4015, ((_e4031 <= 0f) || (_e4033 <= (_e4005 * (((_e4029 * _e4029) + (_e4030 * _e4030)) + _e4033)))), _e4042);
phi_7485_ = vec3<f32>(select(select(select(_e3999, _e3981, _e4015), _e4029, _e4042), _e163, _e4046), select(select(select(_e4000, _e3982, _e4015), _e4030, _e4042), _e174, _e4046), select(select(select(_e4001, _e3983, _e4015), _e4031, _e4042), _e185, _e4046));
phi_7486_ = select(1f, 0f, _e4046);
} else {
phi_7485_ = vec3<f32>(_e163, _e174, _e185);
phi_7486_ = 1f;
}
let _e4053 = phi_7485_;
let _e4055 = phi_7486_;
let _e4058 = (_e3957.member * _e4055);
global_5.member[_e120] = (_e131 * (_e3957.member_2.x * _e4058));
global_5.member[_e132] = (_e141 * (_e3957.member_2.y * _e4058));
global_5.member[_e143] = (_e152 * (_e3957.member_2.z * _e4058));
global_5.member[_e154] = _e4053.x;
global_5.member[_e165] = _e4053.y;
global_5.member[_e176] = _e4053.z;
global_5.member[_e187] = _e196;
global_5.member[_e198] = _e207;
global_5.member[_e209] = _e218;
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
