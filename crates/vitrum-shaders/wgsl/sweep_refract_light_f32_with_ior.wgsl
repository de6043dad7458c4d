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
var phi_1241_: u32;
var phi_4741_: type_28;
var phi_5387_: type_29;
var phi_6220_: type_5;
var phi_7330_: type_30;
var phi_7481_: f32;
var phi_7482_: f32;
var phi_7483_: f32;
var phi_7484_: f32;
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
phi_1241_ = select(select(7u, 3u, (((((((_e318 >= 0f) && (_e318 <= _e373)) && (_e333 >= 0f)) && (_e333 <= _e383)) && (_e348 >= 0f)) && (_e348 <= _e393)) && ((((((_e354 >= 0f) && (_e354 <= _e373)) && (_e360 >= 0f)) && (_e360 <= _e383)) && (_e366 >= 0f)) && (_e366 <= _e393)))), 1u, (((_e784 & 64u) != 0u) || ((((select(_e441, _e438, (_e438 > _e441)) <= _e412) && ((select(_e458, _e455, (_e455 > _e458)) > _e412) || (_e552 != 0u))) && ((select(_e666, _e663, (_e663 > _e666)) <= _e622) && ((select(_e683, _e680, (_e680 > _e683)) > _e622) || (_e778 != 0u)))) && ((_e784 & 32u) != 0u))));
} else {
phi_1241_ = 7u;
}
let _e794 = phi_1241_;
if (_e794 > 1u) {
let _e799 = bitcast<i32>(((_e115 * _e222) + _e113));
let _e802 = (bitcast<i32>(_e97) - 1i);
let _e804 = select(_e802, _e799, (_e799 < _e802));
let _e810 = global_6.member[bitcast<u32>(select(0i, _e804, (_e804 > 0i)))];
let _e811 = (bitcast<i32>(_e227) + _e799);
let _e813 = select(_e802, _e811, (_e811 < _e802));
let _e819 = global_6.member[bitcast<u32>(select(0i, _e813, (_e813 > 0i)))];
let _e821 = f32(bitcast<i32>(_e113));
let _e823 = f32(bitcast<i32>(_e115));
let _e829 = global_1.member.member_5.member;
let _e833 = global_1.member.member_8.member_8;
let _e834 = (_e829 - _e833);
let _e838 = global_1.member.member_8.member_2;
let _e842 = global_1.member.member_8.member_6;
let _e849 = global_1.member.member_8.member_4;
let _e851 = ((_e838 + (_e842 * _e834)) + (((_e821 - _e810) + 0.5f) * _e849));
let _e855 = global_1.member.member_8.member_3;
let _e859 = global_1.member.member_8.member_7;
let _e864 = ((_e855 + (_e859 * _e834)) + (((_e823 - _e819) + 0.5f) * _e849));
let _e868 = global_1.member.member_5.member_1;
let _e869 = (_e868 - _e833);
let _e874 = ((_e838 + (_e842 * _e869)) + ((_e821 + 0.5f) * _e849));
let _e879 = ((_e855 + (_e859 * _e869)) + ((_e823 + 0.5f) * _e849));
let _e883 = global_1.member.member_6.member;
let _e894 = ((((_e883.member.member * _e851) + (_e883.member.member_1 * _e864)) + (_e883.member.member_2 * _e829)) + _e883.member_1);
let _e898 = global_1.member.member_6.member_1;
let _e909 = ((((_e898.member.member * _e851) + (_e898.member.member_1 * _e864)) + (_e898.member.member_2 * _e829)) + _e898.member_1);
let _e913 = global_1.member.member_6.member_2;
let _e924 = ((((_e913.member.member * _e851) + (_e913.member.member_1 * _e864)) + (_e913.member.member_2 * _e829)) + _e913.member_1);
let _e930 = ((((_e883.member.member * _e874) + (_e883.member.member_1 * _e879)) + (_e883.member.member_2 * _e868)) + _e883.member_1);
let _e936 = ((((_e898.member.member * _e874) + (_e898.member.member_1 * _e879)) + (_e898.member.member_2 * _e868)) + _e898.member_1);
let _e942 = ((((_e913.member.member * _e874) + (_e913.member.member_1 * _e879)) + (_e913.member.member_2 * _e868)) + _e913.member_1);
let _e946 = global_1.member.member_7.member;
let _e957 = ((((_e946.member.member * _e874) + (_e946.member.member_1 * _e879)) + (_e946.member.member_2 * _e868)) + _e946.member_1);
let _e961 = global_1.member.member_7.member_1;
let _e972 = ((((_e961.member.member * _e874) + (_e961.member.member_1 * _e879)) + (_e961.member.member_2 * _e868)) + _e961.member_1);
let _e976 = global_1.member.member_7.member_2;
let _e987 = ((((_e976.member.member * _e874) + (_e976.member.member_1 * _e879)) + (_e976.member.member_2 * _e868)) + _e976.member_1);
let _e989 = (_e105.member_2 == 2u);
let _e992 = (((_e105.member_2 == 1u) || _e989) || (_e105.member_2 == 5u));
if _e992 {
let _e997 = global_1.member.member_6.member_3.member;
let _e998 = (_e997 - 0.5f);
let _e1000 = select(-0.5f, _e930, (_e930 > -0.5f));
let _e1002 = select(_e998, _e1000, (_e1000 < _e998));
let _e1007 = global_1.member.member_6.member_3.member_1;
let _e1008 = (_e1007 - 0.5f);
let _e1010 = select(-0.5f, _e936, (_e936 > -0.5f));
let _e1012 = select(_e1008, _e1010, (_e1010 < _e1008));
let _e1017 = global_1.member.member_6.member_3.member_2;
let _e1018 = (_e1017 - 0.5f);
let _e1020 = select(-0.5f, _e942, (_e942 > -0.5f));
let _e1022 = select(_e1018, _e1020, (_e1020 < _e1018));
let _e1024 = select(-1f, _e1002, (_e1002 > -1f));
let _e1026 = select(_e997, _e1024, (_e1024 < _e997));
let _e1033 = select(0i, select(select(i32(_e1026), i32(-2147483648), (_e1026 < -2147483600f)), 2147483647i, (_e1026 > 2147483500f)), (_e1026 == _e1026));
let _e1037 = (_e1033 - select(0i, 1i, (_e1026 < f32(_e1033))));
let _e1039 = select(-1f, _e1012, (_e1012 > -1f));
let _e1041 = select(_e1007, _e1039, (_e1039 < _e1007));
let _e1048 = select(0i, select(select(i32(_e1041), i32(-2147483648), (_e1041 < -2147483600f)), 2147483647i, (_e1041 > 2147483500f)), (_e1041 == _e1041));
let _e1052 = (_e1048 - select(0i, 1i, (_e1041 < f32(_e1048))));
let _e1054 = select(-1f, _e1022, (_e1022 > -1f));
let _e1056 = select(_e1017, _e1054, (_e1054 < _e1017));
let _e1063 = select(0i, select(select(i32(_e1056), i32(-2147483648), (_e1056 < -2147483600f)), 2147483647i, (_e1056 > 2147483500f)), (_e1056 == _e1056));
let _e1067 = (_e1063 - select(0i, 1i, (_e1056 < f32(_e1063))));
let _e1071 = global_1.member.member_6.member_7;
let _e1075 = global_1.member.member_6.member_8;
let _e1083 = (select(0i, select(select(i32(_e1007), i32(-2147483648), (_e1007 < -2147483600f)), 2147483647i, (_e1007 > 2147483500f)), (_e1007 == _e1007)) - 1i);
let _e1086 = (_e1052 + 1i);
let _e1096 = (select(0i, select(select(i32(_e1017), i32(-2147483648), (_e1017 < -2147483600f)), 2147483647i, (_e1017 > 2147483500f)), (_e1017 == _e1017)) - 1i);
let _e1099 = (_e1067 + 1i);
let _e1109 = (select(0i, select(select(i32(_e997), i32(-2147483648), (_e997 < -2147483600f)), 2147483647i, (_e997 > 2147483500f)), (_e997 == _e997)) - 1i);
let _e1110 = (_e1037 - 1i);
let _e1115 = (_e1037 + 1i);
let _e1118 = (_e1037 + 2i);
let _e1121 = (select(0i, _e1052, (_e1052 > 0i)) * _e1071);
let _e1122 = (select(_e1083, _e1086, (_e1086 < _e1083)) * _e1071);
let _e1123 = (select(0i, _e1067, (_e1067 > 0i)) * _e1075);
let _e1124 = (select(_e1096, _e1099, (_e1099 < _e1096)) * _e1075);
local_6 = type_27(array<i32, 4>(select(0i, _e1110, (_e1110 > 0i)), select(0i, _e1037, (_e1037 > 0i)), select(_e1109, _e1115, (_e1115 < _e1109)), select(_e1109, _e1118, (_e1118 < _e1109))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_7 = vec3<f32>((_e1002 - f32(_e1037)), (_e1012 - f32(_e1052)), (_e1022 - f32(_e1067)));
let _e1135 = (_e1123 + _e1121);
let _e1137 = (bitcast<i32>(_e88) - 1i);
let _e1140 = local_6.member[1u];
let _e1141 = (_e1135 + _e1140);
let _e1143 = select(_e1137, _e1141, (_e1141 < _e1137));
let _e1148 = global_2.member[bitcast<u32>(select(0i, _e1143, (_e1143 > 0i)))];
let _e1149 = bitcast<f32>(_e1148);
let _e1152 = local_6.member[2u];
let _e1153 = (_e1135 + _e1152);
let _e1155 = select(_e1137, _e1153, (_e1153 < _e1137));
let _e1160 = global_2.member[bitcast<u32>(select(0i, _e1155, (_e1155 > 0i)))];
let _e1162 = local_7[0u];
let _e1165 = (_e1149 + ((bitcast<f32>(_e1160) - _e1149) * _e1162));
let _e1166 = (_e1123 + _e1122);
let _e1167 = local_6.member[1u];
let _e1168 = (_e1166 + _e1167);
let _e1170 = select(_e1137, _e1168, (_e1168 < _e1137));
let _e1175 = global_2.member[bitcast<u32>(select(0i, _e1170, (_e1170 > 0i)))];
let _e1176 = bitcast<f32>(_e1175);
let _e1177 = local_6.member[2u];
let _e1178 = (_e1166 + _e1177);
let _e1180 = select(_e1137, _e1178, (_e1178 < _e1137));
let _e1185 = global_2.member[bitcast<u32>(select(0i, _e1180, (_e1180 > 0i)))];
let _e1187 = local_7[0u];
let _e1191 = (_e1124 + _e1121);
let _e1192 = local_6.member[1u];
let _e1193 = (_e1191 + _e1192);
let _e1195 = select(_e1137, _e1193, (_e1193 < _e1137));
let _e1200 = global_2.member[bitcast<u32>(select(0i, _e1195, (_e1195 > 0i)))];
let _e1201 = bitcast<f32>(_e1200);
let _e1202 = local_6.member[2u];
let _e1203 = (_e1191 + _e1202);
let _e1205 = select(_e1137, _e1203, (_e1203 < _e1137));
let _e1210 = global_2.member[bitcast<u32>(select(0i, _e1205, (_e1205 > 0i)))];
let _e1212 = local_7[0u];
let _e1215 = (_e1201 + ((bitcast<f32>(_e1210) - _e1201) * _e1212));
let _e1216 = (_e1124 + _e1122);
let _e1217 = local_6.member[1u];
let _e1218 = (_e1216 + _e1217);
let _e1220 = select(_e1137, _e1218, (_e1218 < _e1137));
let _e1225 = global_2.member[bitcast<u32>(select(0i, _e1220, (_e1220 > 0i)))];
let _e1226 = bitcast<f32>(_e1225);
let _e1227 = local_6.member[2u];
let _e1228 = (_e1216 + _e1227);
let _e1230 = select(_e1137, _e1228, (_e1228 < _e1137));
let _e1235 = global_2.member[bitcast<u32>(select(0i, _e1230, (_e1230 > 0i)))];
let _e1237 = local_7[0u];
let _e1242 = local_7[1u];
let _e1245 = (_e1165 + (((_e1176 + ((bitcast<f32>(_e1185) - _e1176) * _e1187)) - _e1165) * _e1242));
let _e1246 = local_7[1u];
let _e1251 = local_7[2u];
let _e1258 = global_1.member.member_6.member_5;
let _e1263 = global_1.member.member_6.member_6;
let _e1264 = (((_e1245 + (((_e1215 + (((_e1226 + ((bitcast<f32>(_e1235) - _e1226) * _e1237)) - _e1215) * _e1246)) - _e1245) * _e1251)) * _e1258) + _e1263);
let _e1266 = select(0f, _e1264, (_e1264 > 0f));
let _e1273 = global_1.member.member_7.member_3.member;
let _e1274 = (_e1273 - 0.5f);
let _e1276 = select(-0.5f, _e957, (_e957 > -0.5f));
let _e1278 = select(_e1274, _e1276, (_e1276 < _e1274));
let _e1283 = global_1.member.member_7.member_3.member_1;
let _e1284 = (_e1283 - 0.5f);
let _e1286 = select(-0.5f, _e972, (_e972 > -0.5f));
let _e1288 = select(_e1284, _e1286, (_e1286 < _e1284));
let _e1293 = global_1.member.member_7.member_3.member_2;
let _e1294 = (_e1293 - 0.5f);
let _e1296 = select(-0.5f, _e987, (_e987 > -0.5f));
let _e1298 = select(_e1294, _e1296, (_e1296 < _e1294));
let _e1300 = select(-1f, _e1278, (_e1278 > -1f));
let _e1302 = select(_e1273, _e1300, (_e1300 < _e1273));
let _e1309 = select(0i, select(select(i32(_e1302), i32(-2147483648), (_e1302 < -2147483600f)), 2147483647i, (_e1302 > 2147483500f)), (_e1302 == _e1302));
let _e1313 = (_e1309 - select(0i, 1i, (_e1302 < f32(_e1309))));
let _e1315 = select(-1f, _e1288, (_e1288 > -1f));
let _e1317 = select(_e1283, _e1315, (_e1315 < _e1283));
let _e1324 = select(0i, select(select(i32(_e1317), i32(-2147483648), (_e1317 < -2147483600f)), 2147483647i, (_e1317 > 2147483500f)), (_e1317 == _e1317));
let _e1328 = (_e1324 - select(0i, 1i, (_e1317 < f32(_e1324))));
let _e1330 = select(-1f, _e1298, (_e1298 > -1f));
let _e1332 = select(_e1293, _e1330, (_e1330 < _e1293));
let _e1339 = select(0i, select(select(i32(_e1332), i32(-2147483648), (_e1332 < -2147483600f)), 2147483647i, (_e1332 > 2147483500f)), (_e1332 == _e1332));
let _e1343 = (_e1339 - select(0i, 1i, (_e1332 < f32(_e1339))));
let _e1347 = global_1.member.member_7.member_7;
let _e1351 = global_1.member.member_7.member_8;
let _e1359 = (select(0i, select(select(i32(_e1283), i32(-2147483648), (_e1283 < -2147483600f)), 2147483647i, (_e1283 > 2147483500f)), (_e1283 == _e1283)) - 1i);
let _e1360 = (_e1328 - 1i);
let _e1365 = (_e1328 + 1i);
let _e1368 = (_e1328 + 2i);
let _e1378 = (select(0i, select(select(i32(_e1293), i32(-2147483648), (_e1293 < -2147483600f)), 2147483647i, (_e1293 > 2147483500f)), (_e1293 == _e1293)) - 1i);
let _e1379 = (_e1343 - 1i);
let _e1384 = (_e1343 + 1i);
let _e1387 = (_e1343 + 2i);
let _e1397 = (select(0i, select(select(i32(_e1273), i32(-2147483648), (_e1273 < -2147483600f)), 2147483647i, (_e1273 > 2147483500f)), (_e1273 == _e1273)) - 1i);
let _e1398 = (_e1313 - 1i);
let _e1403 = (_e1313 + 1i);
let _e1406 = (_e1313 + 2i);
let _e1409 = (select(0i, _e1360, (_e1360 > 0i)) * _e1347);
let _e1410 = (select(0i, _e1328, (_e1328 > 0i)) * _e1347);
let _e1411 = (select(_e1359, _e1365, (_e1365 < _e1359)) * _e1347);
let _e1412 = (select(_e1359, _e1368, (_e1368 < _e1359)) * _e1347);
let _e1413 = (select(0i, _e1379, (_e1379 > 0i)) * _e1351);
let _e1414 = (select(0i, _e1343, (_e1343 > 0i)) * _e1351);
let _e1415 = (select(_e1378, _e1384, (_e1384 < _e1378)) * _e1351);
let _e1416 = (select(_e1378, _e1387, (_e1387 < _e1378)) * _e1351);
local_4 = type_27(array<i32, 4>(select(0i, _e1398, (_e1398 > 0i)), select(0i, _e1313, (_e1313 > 0i)), select(_e1397, _e1403, (_e1403 < _e1397)), select(_e1397, _e1406, (_e1406 < _e1397))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_5 = vec3<f32>((_e1278 - f32(_e1313)), (_e1288 - f32(_e1328)), (_e1298 - f32(_e1343)));
let _e1427 = (_e1414 + _e1410);
let _e1430 = local_4.member[0u];
let _e1431 = (_e1427 + _e1430);
let _e1433 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e1435 = select(_e1433, _e1431, (_e1431 < _e1433));
let _e1440 = global_7.member[bitcast<u32>(select(0i, _e1435, (_e1435 > 0i)))];
let _e1441 = bitcast<f32>(_e1440);
let _e1444 = local_4.member[1u];
let _e1445 = (_e1427 + _e1444);
let _e1447 = select(_e1433, _e1445, (_e1445 < _e1433));
let _e1452 = global_7.member[bitcast<u32>(select(0i, _e1447, (_e1447 > 0i)))];
let _e1453 = bitcast<f32>(_e1452);
let _e1456 = local_4.member[2u];
let _e1457 = (_e1427 + _e1456);
let _e1459 = select(_e1433, _e1457, (_e1457 < _e1433));
let _e1464 = global_7.member[bitcast<u32>(select(0i, _e1459, (_e1459 > 0i)))];
let _e1465 = bitcast<f32>(_e1464);
let _e1468 = local_4.member[3u];
let _e1469 = (_e1427 + _e1468);
let _e1471 = select(_e1433, _e1469, (_e1469 < _e1433));
let _e1476 = global_7.member[bitcast<u32>(select(0i, _e1471, (_e1471 > 0i)))];
let _e1478 = local_5[0u];
let _e1481 = (_e1441 + ((_e1453 - _e1441) * _e1478));
let _e1482 = local_5[0u];
let _e1485 = (_e1453 + ((_e1465 - _e1453) * _e1482));
let _e1486 = local_5[0u];
let _e1489 = (_e1465 + ((bitcast<f32>(_e1476) - _e1465) * _e1486));
let _e1490 = (_e1414 + _e1411);
let _e1491 = local_4.member[0u];
let _e1492 = (_e1490 + _e1491);
let _e1494 = select(_e1433, _e1492, (_e1492 < _e1433));
let _e1499 = global_7.member[bitcast<u32>(select(0i, _e1494, (_e1494 > 0i)))];
let _e1500 = bitcast<f32>(_e1499);
let _e1501 = local_4.member[1u];
let _e1502 = (_e1490 + _e1501);
let _e1504 = select(_e1433, _e1502, (_e1502 < _e1433));
let _e1509 = global_7.member[bitcast<u32>(select(0i, _e1504, (_e1504 > 0i)))];
let _e1510 = bitcast<f32>(_e1509);
let _e1511 = local_4.member[2u];
let _e1512 = (_e1490 + _e1511);
let _e1514 = select(_e1433, _e1512, (_e1512 < _e1433));
let _e1519 = global_7.member[bitcast<u32>(select(0i, _e1514, (_e1514 > 0i)))];
let _e1520 = bitcast<f32>(_e1519);
let _e1521 = local_4.member[3u];
let _e1522 = (_e1490 + _e1521);
let _e1524 = select(_e1433, _e1522, (_e1522 < _e1433));
let _e1529 = global_7.member[bitcast<u32>(select(0i, _e1524, (_e1524 > 0i)))];
let _e1531 = local_5[0u];
let _e1535 = local_5[0u];
let _e1538 = (_e1510 + ((_e1520 - _e1510) * _e1535));
let _e1539 = local_5[0u];
let _e1543 = (_e1415 + _e1410);
let _e1544 = local_4.member[0u];
let _e1545 = (_e1543 + _e1544);
let _e1547 = select(_e1433, _e1545, (_e1545 < _e1433));
let _e1552 = global_7.member[bitcast<u32>(select(0i, _e1547, (_e1547 > 0i)))];
let _e1553 = bitcast<f32>(_e1552);
let _e1554 = local_4.member[1u];
let _e1555 = (_e1543 + _e1554);
let _e1557 = select(_e1433, _e1555, (_e1555 < _e1433));
let _e1562 = global_7.member[bitcast<u32>(select(0i, _e1557, (_e1557 > 0i)))];
let _e1563 = bitcast<f32>(_e1562);
let _e1564 = local_4.member[2u];
let _e1565 = (_e1543 + _e1564);
let _e1567 = select(_e1433, _e1565, (_e1565 < _e1433));
let _e1572 = global_7.member[bitcast<u32>(select(0i, _e1567, (_e1567 > 0i)))];
let _e1573 = bitcast<f32>(_e1572);
let _e1574 = local_4.member[3u];
let _e1575 = (_e1543 + _e1574);
let _e1577 = select(_e1433, _e1575, (_e1575 < _e1433));
let _e1582 = global_7.member[bitcast<u32>(select(0i, _e1577, (_e1577 > 0i)))];
let _e1584 = local_5[0u];
let _e1587 = (_e1553 + ((_e1563 - _e1553) * _e1584));
let _e1588 = local_5[0u];
let _e1591 = (_e1563 + ((_e1573 - _e1563) * _e1588));
let _e1592 = local_5[0u];
let _e1595 = (_e1573 + ((bitcast<f32>(_e1582) - _e1573) * _e1592));
let _e1596 = (_e1415 + _e1411);
let _e1597 = local_4.member[0u];
let _e1598 = (_e1596 + _e1597);
let _e1600 = select(_e1433, _e1598, (_e1598 < _e1433));
let _e1605 = global_7.member[bitcast<u32>(select(0i, _e1600, (_e1600 > 0i)))];
let _e1606 = bitcast<f32>(_e1605);
let _e1607 = local_4.member[1u];
let _e1608 = (_e1596 + _e1607);
let _e1610 = select(_e1433, _e1608, (_e1608 < _e1433));
let _e1615 = global_7.member[bitcast<u32>(select(0i, _e1610, (_e1610 > 0i)))];
let _e1616 = bitcast<f32>(_e1615);
let _e1617 = local_4.member[2u];
let _e1618 = (_e1596 + _e1617);
let _e1620 = select(_e1433, _e1618, (_e1618 < _e1433));
let _e1625 = global_7.member[bitcast<u32>(select(0i, _e1620, (_e1620 > 0i)))];
let _e1626 = bitcast<f32>(_e1625);
let _e1627 = local_4.member[3u];
let _e1628 = (_e1596 + _e1627);
let _e1630 = select(_e1433, _e1628, (_e1628 < _e1433));
let _e1635 = global_7.member[bitcast<u32>(select(0i, _e1630, (_e1630 > 0i)))];
let _e1637 = local_5[0u];
let _e1641 = local_5[0u];
let _e1644 = (_e1616 + ((_e1626 - _e1616) * _e1641));
let _e1645 = local_5[0u];
let _e1649 = (_e1414 + _e1409);
let _e1650 = local_4.member[1u];
let _e1651 = (_e1649 + _e1650);
let _e1653 = select(_e1433, _e1651, (_e1651 < _e1433));
let _e1658 = global_7.member[bitcast<u32>(select(0i, _e1653, (_e1653 > 0i)))];
let _e1659 = bitcast<f32>(_e1658);
let _e1660 = local_4.member[2u];
let _e1661 = (_e1649 + _e1660);
let _e1663 = select(_e1433, _e1661, (_e1661 < _e1433));
let _e1668 = global_7.member[bitcast<u32>(select(0i, _e1663, (_e1663 > 0i)))];
let _e1670 = local_5[0u];
let _e1673 = (_e1659 + ((bitcast<f32>(_e1668) - _e1659) * _e1670));
let _e1674 = (_e1414 + _e1412);
let _e1675 = local_4.member[1u];
let _e1676 = (_e1674 + _e1675);
let _e1678 = select(_e1433, _e1676, (_e1676 < _e1433));
let _e1683 = global_7.member[bitcast<u32>(select(0i, _e1678, (_e1678 > 0i)))];
let _e1684 = bitcast<f32>(_e1683);
let _e1685 = local_4.member[2u];
let _e1686 = (_e1674 + _e1685);
let _e1688 = select(_e1433, _e1686, (_e1686 < _e1433));
let _e1693 = global_7.member[bitcast<u32>(select(0i, _e1688, (_e1688 > 0i)))];
let _e1695 = local_5[0u];
let _e1699 = (_e1415 + _e1409);
let _e1700 = local_4.member[1u];
let _e1701 = (_e1699 + _e1700);
let _e1703 = select(_e1433, _e1701, (_e1701 < _e1433));
let _e1708 = global_7.member[bitcast<u32>(select(0i, _e1703, (_e1703 > 0i)))];
let _e1709 = bitcast<f32>(_e1708);
let _e1710 = local_4.member[2u];
let _e1711 = (_e1699 + _e1710);
let _e1713 = select(_e1433, _e1711, (_e1711 < _e1433));
let _e1718 = global_7.member[bitcast<u32>(select(0i, _e1713, (_e1713 > 0i)))];
let _e1720 = local_5[0u];
let _e1723 = (_e1709 + ((bitcast<f32>(_e1718) - _e1709) * _e1720));
let _e1724 = (_e1415 + _e1412);
let _e1725 = local_4.member[1u];
let _e1726 = (_e1724 + _e1725);
let _e1728 = select(_e1433, _e1726, (_e1726 < _e1433));
let _e1733 = global_7.member[bitcast<u32>(select(0i, _e1728, (_e1728 > 0i)))];
let _e1734 = bitcast<f32>(_e1733);
let _e1735 = local_4.member[2u];
let _e1736 = (_e1724 + _e1735);
let _e1738 = select(_e1433, _e1736, (_e1736 < _e1433));
let _e1743 = global_7.member[bitcast<u32>(select(0i, _e1738, (_e1738 > 0i)))];
let _e1745 = local_5[0u];
let _e1749 = (_e1413 + _e1410);
let _e1750 = local_4.member[1u];
let _e1751 = (_e1749 + _e1750);
let _e1753 = select(_e1433, _e1751, (_e1751 < _e1433));
let _e1758 = global_7.member[bitcast<u32>(select(0i, _e1753, (_e1753 > 0i)))];
let _e1759 = bitcast<f32>(_e1758);
let _e1760 = local_4.member[2u];
let _e1761 = (_e1749 + _e1760);
let _e1763 = select(_e1433, _e1761, (_e1761 < _e1433));
let _e1768 = global_7.member[bitcast<u32>(select(0i, _e1763, (_e1763 > 0i)))];
let _e1770 = local_5[0u];
let _e1773 = (_e1759 + ((bitcast<f32>(_e1768) - _e1759) * _e1770));
let _e1774 = (_e1416 + _e1410);
let _e1775 = local_4.member[1u];
let _e1776 = (_e1774 + _e1775);
let _e1778 = select(_e1433, _e1776, (_e1776 < _e1433));
let _e1783 = global_7.member[bitcast<u32>(select(0i, _e1778, (_e1778 > 0i)))];
let _e1784 = bitcast<f32>(_e1783);
let _e1785 = local_4.member[2u];
let _e1786 = (_e1774 + _e1785);
let _e1788 = select(_e1433, _e1786, (_e1786 < _e1433));
let _e1793 = global_7.member[bitcast<u32>(select(0i, _e1788, (_e1788 > 0i)))];
let _e1795 = local_5[0u];
let _e1798 = (_e1784 + ((bitcast<f32>(_e1793) - _e1784) * _e1795));
let _e1799 = (_e1413 + _e1411);
let _e1800 = local_4.member[1u];
let _e1801 = (_e1799 + _e1800);
let _e1803 = select(_e1433, _e1801, (_e1801 < _e1433));
let _e1808 = global_7.member[bitcast<u32>(select(0i, _e1803, (_e1803 > 0i)))];
let _e1809 = bitcast<f32>(_e1808);
let _e1810 = local_4.member[2u];
let _e1811 = (_e1799 + _e1810);
let _e1813 = select(_e1433, _e1811, (_e1811 < _e1433));
let _e1818 = global_7.member[bitcast<u32>(select(0i, _e1813, (_e1813 > 0i)))];
let _e1820 = local_5[0u];
let _e1824 = (_e1416 + _e1411);
let _e1825 = local_4.member[1u];
let _e1826 = (_e1824 + _e1825);
let _e1828 = select(_e1433, _e1826, (_e1826 < _e1433));
let _e1833 = global_7.member[bitcast<u32>(select(0i, _e1828, (_e1828 > 0i)))];
let _e1834 = bitcast<f32>(_e1833);
let _e1835 = local_4.member[2u];
let _e1836 = (_e1824 + _e1835);
let _e1838 = select(_e1433, _e1836, (_e1836 < _e1433));
let _e1843 = global_7.member[bitcast<u32>(select(0i, _e1838, (_e1838 > 0i)))];
let _e1845 = local_5[0u];
let _e1850 = local_5[1u];
let _e1853 = (_e1485 + ((_e1538 - _e1485) * _e1850));
let _e1854 = local_5[1u];
let _e1857 = (_e1591 + ((_e1644 - _e1591) * _e1854));
let _e1858 = local_5[1u];
let _e1861 = (_e1481 + (((_e1500 + ((_e1510 - _e1500) * _e1531)) - _e1481) * _e1858));
let _e1862 = local_5[1u];
let _e1867 = local_5[2u];
let _e1871 = local_5[1u];
let _e1874 = (_e1489 + (((_e1520 + ((bitcast<f32>(_e1529) - _e1520) * _e1539)) - _e1489) * _e1871));
let _e1875 = local_5[1u];
let _e1879 = local_5[2u];
let _e1883 = local_5[1u];
let _e1886 = (_e1673 + ((_e1485 - _e1673) * _e1883));
let _e1887 = local_5[1u];
let _e1891 = local_5[2u];
let _e1895 = local_5[1u];
let _e1898 = (_e1538 + (((_e1684 + ((bitcast<f32>(_e1693) - _e1684) * _e1695)) - _e1538) * _e1895));
let _e1899 = local_5[1u];
let _e1903 = local_5[2u];
let _e1907 = local_5[1u];
let _e1910 = (_e1773 + (((_e1809 + ((bitcast<f32>(_e1818) - _e1809) * _e1820)) - _e1773) * _e1907));
let _e1911 = local_5[2u];
let _e1915 = local_5[1u];
let _e1919 = local_5[2u];
let _e1923 = local_5[2u];
let _e1930 = global_1.member.member_7.member_5;
let _e1935 = global_1.member.member_7.member_6;
let _e1936 = (((_e1853 + ((_e1857 - _e1853) * _e1923)) * _e1930) + _e1935);
let _e1938 = select(0f, _e1936, (_e1936 > 0f));
let _e1942 = (((_e1861 + (((_e1587 + (((_e1606 + ((_e1616 - _e1606) * _e1637)) - _e1587) * _e1862)) - _e1861) * _e1867)) * _e1930) + _e1935);
let _e1944 = select(0f, _e1942, (_e1942 > 0f));
let _e1946 = select(1f, _e1944, (_e1944 < 1f));
let _e1948 = (((_e1874 + (((_e1595 + (((_e1626 + ((bitcast<f32>(_e1635) - _e1626) * _e1645)) - _e1595) * _e1875)) - _e1874) * _e1879)) * _e1930) + _e1935);
let _e1950 = select(0f, _e1948, (_e1948 > 0f));
let _e1952 = select(1f, _e1950, (_e1950 < 1f));
let _e1954 = (((_e1886 + (((_e1723 + ((_e1591 - _e1723) * _e1887)) - _e1886) * _e1891)) * _e1930) + _e1935);
let _e1956 = select(0f, _e1954, (_e1954 > 0f));
let _e1958 = select(1f, _e1956, (_e1956 < 1f));
let _e1960 = (((_e1898 + (((_e1644 + (((_e1734 + ((bitcast<f32>(_e1743) - _e1734) * _e1745)) - _e1644) * _e1899)) - _e1898) * _e1903)) * _e1930) + _e1935);
let _e1962 = select(0f, _e1960, (_e1960 > 0f));
let _e1964 = select(1f, _e1962, (_e1962 < 1f));
let _e1966 = (((_e1910 + ((_e1853 - _e1910) * _e1911)) * _e1930) + _e1935);
let _e1968 = select(0f, _e1966, (_e1966 > 0f));
let _e1970 = select(1f, _e1968, (_e1968 < 1f));
let _e1972 = (((_e1857 + (((_e1798 + (((_e1834 + ((bitcast<f32>(_e1843) - _e1834) * _e1845)) - _e1798) * _e1915)) - _e1857) * _e1919)) * _e1930) + _e1935);
let _e1974 = select(0f, _e1972, (_e1972 > 0f));
let _e1976 = select(1f, _e1974, (_e1974 < 1f));
let _e1977 = (select(1f, _e1938, (_e1938 < 1f)) * 1024f);
let _e1978 = (1024f - 1f);
let _e1980 = select(0f, _e1977, (_e1977 > 0f));
let _e1982 = select(_e1978, _e1980, (_e1980 < _e1978));
let _e1989 = select(0i, select(select(i32(_e1982), i32(-2147483648), (_e1982 < -2147483600f)), 2147483647i, (_e1982 > 2147483500f)), (_e1982 == _e1982));
let _e1993 = (_e1989 - select(0i, 1i, (_e1982 < f32(_e1989))));
let _e1994 = (262147i + _e1993);
let _e1996 = (bitcast<i32>(_e95) - 1i);
let _e1998 = select(_e1996, _e1994, (_e1994 < _e1996));
let _e2004 = global_4.member[bitcast<u32>(select(0i, _e1998, (_e1998 > 0i)))];
let _e2014 = select(_e1996, 262146i, (262146i < _e1996));
let _e2020 = global_4.member[bitcast<u32>(select(0i, _e2014, (_e2014 > 0i)))];
let _e2021 = bitcast<f32>(_e2020);
let _e2022 = (f32((bitcast<i32>((_e2004 & 4095u)) - 2048i)) * _e2021);
let _e2024 = select(_e1996, 262144i, (262144i < _e1996));
let _e2030 = global_4.member[bitcast<u32>(select(0i, _e2024, (_e2024 > 0i)))];
let _e2031 = bitcast<f32>(_e2030);
let _e2033 = select(_e1996, 262145i, (262145i < _e1996));
let _e2039 = global_4.member[bitcast<u32>(select(0i, _e2033, (_e2033 > 0i)))];
let _e2040 = bitcast<f32>(_e2039);
let _e2046 = ((_e2031 + (f32(bitcast<i32>((_e2004 >> bitcast<u32>(12u)))) * _e2040)) + (_e2022 * (_e1977 - f32(_e1993))));
let _e2047 = (_e2022 * 1024f);
if _e989 {
let _e2054 = ((0.5f * (_e1952 - _e1946)) * _e2047);
let _e2055 = ((0.5f * (_e1964 - _e1958)) * _e2047);
let _e2056 = ((0.5f * (_e1976 - _e1970)) * _e2047);
phi_4741_ = type_28(_e2046, vec3<f32>(_e2054, _e2055, _e2056), vec3<f32>((_e2054 * _e2046), (_e2055 * _e2046), (_e2056 * _e2046)));
} else {
let _e2063 = (_e1946 * 1024f);
let _e2065 = select(0f, _e2063, (_e2063 > 0f));
let _e2067 = select(_e1978, _e2065, (_e2065 < _e1978));
let _e2074 = select(0i, select(select(i32(_e2067), i32(-2147483648), (_e2067 < -2147483600f)), 2147483647i, (_e2067 > 2147483500f)), (_e2067 == _e2067));
let _e2078 = (_e2074 - select(0i, 1i, (_e2067 < f32(_e2074))));
let _e2079 = (262147i + _e2078);
let _e2081 = select(_e1996, _e2079, (_e2079 < _e1996));
let _e2087 = global_4.member[bitcast<u32>(select(0i, _e2081, (_e2081 > 0i)))];
let _e2102 = ((_e2031 + (f32(bitcast<i32>((_e2087 >> bitcast<u32>(12u)))) * _e2040)) + ((f32((bitcast<i32>((_e2087 & 4095u)) - 2048i)) * _e2021) * (_e2063 - f32(_e2078))));
let _e2103 = (_e1952 * 1024f);
let _e2105 = select(0f, _e2103, (_e2103 > 0f));
let _e2107 = select(_e1978, _e2105, (_e2105 < _e1978));
let _e2114 = select(0i, select(select(i32(_e2107), i32(-2147483648), (_e2107 < -2147483600f)), 2147483647i, (_e2107 > 2147483500f)), (_e2107 == _e2107));
let _e2118 = (_e2114 - select(0i, 1i, (_e2107 < f32(_e2114))));
let _e2119 = (262147i + _e2118);
let _e2121 = select(_e1996, _e2119, (_e2119 < _e1996));
let _e2127 = global_4.member[bitcast<u32>(select(0i, _e2121, (_e2121 > 0i)))];
let _e2142 = ((_e2031 + (f32(bitcast<i32>((_e2127 >> bitcast<u32>(12u)))) * _e2040)) + ((f32((bitcast<i32>((_e2127 & 4095u)) - 2048i)) * _e2021) * (_e2103 - f32(_e2118))));
let _e2143 = (_e1958 * 1024f);
let _e2145 = select(0f, _e2143, (_e2143 > 0f));
let _e2147 = select(_e1978, _e2145, (_e2145 < _e1978));
let _e2154 = select(0i, select(select(i32(_e2147), i32(-2147483648), (_e2147 < -2147483600f)), 2147483647i, (_e2147 > 2147483500f)), (_e2147 == _e2147));
let _e2158 = (_e2154 - select(0i, 1i, (_e2147 < f32(_e2154))));
let _e2159 = (262147i + _e2158);
let _e2161 = select(_e1996, _e2159, (_e2159 < _e1996));
let _e2167 = global_4.member[bitcast<u32>(select(0i, _e2161, (_e2161 > 0i)))];
let _e2182 = ((_e2031 + (f32(bitcast<i32>((_e2167 >> bitcast<u32>(12u)))) * _e2040)) + ((f32((bitcast<i32>((_e2167 & 4095u)) - 2048i)) * _e2021) * (_e2143 - f32(_e2158))));
let _e2183 = (_e1964 * 1024f);
let _e2185 = select(0f, _e2183, (_e2183 > 0f));
let _e2187 = select(_e1978, _e2185, (_e2185 < _e1978));
let _e2194 = select(0i, select(select(i32(_e2187), i32(-2147483648), (_e2187 < -2147483600f)), 2147483647i, (_e2187 > 2147483500f)), (_e2187 == _e2187));
let _e2198 = (_e2194 - select(0i, 1i, (_e2187 < f32(_e2194))));
let _e2199 = (262147i + _e2198);
let _e2201 = select(_e1996, _e2199, (_e2199 < _e1996));
let _e2207 = global_4.member[bitcast<u32>(select(0i, _e2201, (_e2201 > 0i)))];
let _e2222 = ((_e2031 + (f32(bitcast<i32>((_e2207 >> bitcast<u32>(12u)))) * _e2040)) + ((f32((bitcast<i32>((_e2207 & 4095u)) - 2048i)) * _e2021) * (_e2183 - f32(_e2198))));
let _e2223 = (_e1970 * 1024f);
let _e2225 = select(0f, _e2223, (_e2223 > 0f));
let _e2227 = select(_e1978, _e2225, (_e2225 < _e1978));
let _e2234 = select(0i, select(select(i32(_e2227), i32(-2147483648), (_e2227 < -2147483600f)), 2147483647i, (_e2227 > 2147483500f)), (_e2227 == _e2227));
let _e2238 = (_e2234 - select(0i, 1i, (_e2227 < f32(_e2234))));
let _e2239 = (262147i + _e2238);
let _e2241 = select(_e1996, _e2239, (_e2239 < _e1996));
let _e2247 = global_4.member[bitcast<u32>(select(0i, _e2241, (_e2241 > 0i)))];
let _e2262 = ((_e2031 + (f32(bitcast<i32>((_e2247 >> bitcast<u32>(12u)))) * _e2040)) + ((f32((bitcast<i32>((_e2247 & 4095u)) - 2048i)) * _e2021) * (_e2223 - f32(_e2238))));
let _e2263 = (_e1976 * 1024f);
let _e2265 = select(0f, _e2263, (_e2263 > 0f));
let _e2267 = select(_e1978, _e2265, (_e2265 < _e1978));
let _e2274 = select(0i, select(select(i32(_e2267), i32(-2147483648), (_e2267 < -2147483600f)), 2147483647i, (_e2267 > 2147483500f)), (_e2267 == _e2267));
let _e2278 = (_e2274 - select(0i, 1i, (_e2267 < f32(_e2274))));
let _e2279 = (262147i + _e2278);
let _e2281 = select(_e1996, _e2279, (_e2279 < _e1996));
let _e2287 = global_4.member[bitcast<u32>(select(0i, _e2281, (_e2281 > 0i)))];
let _e2302 = ((_e2031 + (f32(bitcast<i32>((_e2287 >> bitcast<u32>(12u)))) * _e2040)) + ((f32((bitcast<i32>((_e2287 & 4095u)) - 2048i)) * _e2021) * (_e2263 - f32(_e2278))));
let _e2303 = (_e2142 - _e2102);
let _e2305 = (_e2222 - _e2182);
let _e2307 = (_e2302 - _e2262);
phi_4741_ = type_28(_e2046, vec3<f32>((0.5f * _e2303), (0.5f * _e2305), (0.5f * _e2307)), vec3<f32>((0.25f * (_e2303 * (_e2142 + _e2102))), (0.25f * (_e2305 * (_e2222 + _e2182))), (0.25f * (_e2307 * (_e2302 + _e2262)))));
}
let _e2322 = phi_4741_;
let _e2337 = select(0f, 1f, ((((((_e957 >= -0.5f) && (_e957 <= _e1274)) && (_e972 >= -0.5f)) && (_e972 <= _e1284)) && (_e987 >= -0.5f)) && (_e987 <= _e1294)));
let _e2339 = (0.5f * (_e1952 - _e1946));
let _e2341 = (0.5f * (_e1964 - _e1958));
let _e2343 = (0.5f * (_e1976 - _e1970));
let _e2349 = global_1.member.member_7.member.member.member;
let _e2355 = global_1.member.member_7.member.member.member_1;
let _e2361 = global_1.member.member_7.member.member.member_2;
let _e2367 = global_1.member.member_7.member_1.member.member;
let _e2373 = global_1.member.member_7.member_1.member.member_1;
let _e2379 = global_1.member.member_7.member_1.member.member_2;
let _e2385 = global_1.member.member_7.member_2.member.member;
let _e2391 = global_1.member.member_7.member_2.member.member_1;
let _e2397 = global_1.member.member_7.member_2.member.member_2;
phi_5387_ = type_29(select(1f, _e1266, (_e1266 < 1f)), vec3<f32>(((((_e2349 * _e2339) + (_e2367 * _e2341)) + (_e2385 * _e2343)) * _e2337), ((((_e2355 * _e2339) + (_e2373 * _e2341)) + (_e2391 * _e2343)) * _e2337), ((((_e2361 * _e2339) + (_e2379 * _e2341)) + (_e2397 * _e2343)) * _e2337)), _e2322.member, vec3<f32>(((((_e2349 * _e2322.member_2.x) + (_e2367 * _e2322.member_2.y)) + (_e2385 * _e2322.member_2.z)) * _e2337), ((((_e2355 * _e2322.member_2.x) + (_e2373 * _e2322.member_2.y)) + (_e2391 * _e2322.member_2.z)) * _e2337), ((((_e2361 * _e2322.member_2.x) + (_e2379 * _e2322.member_2.y)) + (_e2397 * _e2322.member_2.z)) * _e2337)), vec3<f32>(((((_e2349 * _e2322.member_1.x) + (_e2367 * _e2322.member_1.y)) + (_e2385 * _e2322.member_1.z)) * _e2337), ((((_e2355 * _e2322.member_1.x) + (_e2373 * _e2322.member_1.y)) + (_e2391 * _e2322.member_1.z)) * _e2337), ((((_e2361 * _e2322.member_1.x) + (_e2379 * _e2322.member_1.y)) + (_e2397 * _e2322.member_1.z)) * _e2337)));
} else {
let _e2466 = global_1.member.member_6.member_3.member;
let _e2467 = (_e2466 - 0.5f);
let _e2469 = select(-0.5f, _e930, (_e930 > -0.5f));
let _e2471 = select(_e2467, _e2469, (_e2469 < _e2467));
let _e2476 = global_1.member.member_6.member_3.member_1;
let _e2477 = (_e2476 - 0.5f);
let _e2479 = select(-0.5f, _e936, (_e936 > -0.5f));
let _e2481 = select(_e2477, _e2479, (_e2479 < _e2477));
let _e2486 = global_1.member.member_6.member_3.member_2;
let _e2487 = (_e2486 - 0.5f);
let _e2489 = select(-0.5f, _e942, (_e942 > -0.5f));
let _e2491 = select(_e2487, _e2489, (_e2489 < _e2487));
let _e2493 = select(-1f, _e2471, (_e2471 > -1f));
let _e2495 = select(_e2466, _e2493, (_e2493 < _e2466));
let _e2502 = select(0i, select(select(i32(_e2495), i32(-2147483648), (_e2495 < -2147483600f)), 2147483647i, (_e2495 > 2147483500f)), (_e2495 == _e2495));
let _e2506 = (_e2502 - select(0i, 1i, (_e2495 < f32(_e2502))));
let _e2508 = select(-1f, _e2481, (_e2481 > -1f));
let _e2510 = select(_e2476, _e2508, (_e2508 < _e2476));
let _e2517 = select(0i, select(select(i32(_e2510), i32(-2147483648), (_e2510 < -2147483600f)), 2147483647i, (_e2510 > 2147483500f)), (_e2510 == _e2510));
let _e2521 = (_e2517 - select(0i, 1i, (_e2510 < f32(_e2517))));
let _e2523 = select(-1f, _e2491, (_e2491 > -1f));
let _e2525 = select(_e2486, _e2523, (_e2523 < _e2486));
let _e2532 = select(0i, select(select(i32(_e2525), i32(-2147483648), (_e2525 < -2147483600f)), 2147483647i, (_e2525 > 2147483500f)), (_e2525 == _e2525));
let _e2536 = (_e2532 - select(0i, 1i, (_e2525 < f32(_e2532))));
let _e2540 = global_1.member.member_6.member_7;
let _e2544 = global_1.member.member_6.member_8;
let _e2552 = (select(0i, select(select(i32(_e2476), i32(-2147483648), (_e2476 < -2147483600f)), 2147483647i, (_e2476 > 2147483500f)), (_e2476 == _e2476)) - 1i);
let _e2555 = (_e2521 + 1i);
let _e2565 = (select(0i, select(select(i32(_e2486), i32(-2147483648), (_e2486 < -2147483600f)), 2147483647i, (_e2486 > 2147483500f)), (_e2486 == _e2486)) - 1i);
let _e2568 = (_e2536 + 1i);
let _e2578 = (select(0i, select(select(i32(_e2466), i32(-2147483648), (_e2466 < -2147483600f)), 2147483647i, (_e2466 > 2147483500f)), (_e2466 == _e2466)) - 1i);
let _e2579 = (_e2506 - 1i);
let _e2584 = (_e2506 + 1i);
let _e2587 = (_e2506 + 2i);
let _e2590 = (select(0i, _e2521, (_e2521 > 0i)) * _e2540);
let _e2591 = (select(_e2552, _e2555, (_e2555 < _e2552)) * _e2540);
let _e2592 = (select(0i, _e2536, (_e2536 > 0i)) * _e2544);
let _e2593 = (select(_e2565, _e2568, (_e2568 < _e2565)) * _e2544);
local_2 = type_27(array<i32, 4>(select(0i, _e2579, (_e2579 > 0i)), select(0i, _e2506, (_e2506 > 0i)), select(_e2578, _e2584, (_e2584 < _e2578)), select(_e2578, _e2587, (_e2587 < _e2578))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_3 = vec3<f32>((_e2471 - f32(_e2506)), (_e2481 - f32(_e2521)), (_e2491 - f32(_e2536)));
let _e2604 = (_e2592 + _e2590);
let _e2607 = local_2.member[1u];
let _e2608 = (_e2604 + _e2607);
let _e2610 = (bitcast<i32>(_e88) - 1i);
let _e2612 = select(_e2610, _e2608, (_e2608 < _e2610));
let _e2617 = global_2.member[bitcast<u32>(select(0i, _e2612, (_e2612 > 0i)))];
let _e2618 = bitcast<f32>(_e2617);
let _e2621 = local_2.member[2u];
let _e2622 = (_e2604 + _e2621);
let _e2624 = select(_e2610, _e2622, (_e2622 < _e2610));
let _e2629 = global_2.member[bitcast<u32>(select(0i, _e2624, (_e2624 > 0i)))];
let _e2631 = local_3[0u];
let _e2634 = (_e2618 + ((bitcast<f32>(_e2629) - _e2618) * _e2631));
let _e2635 = (_e2592 + _e2591);
let _e2636 = local_2.member[1u];
let _e2637 = (_e2635 + _e2636);
let _e2639 = select(_e2610, _e2637, (_e2637 < _e2610));
let _e2644 = global_2.member[bitcast<u32>(select(0i, _e2639, (_e2639 > 0i)))];
let _e2645 = bitcast<f32>(_e2644);
let _e2646 = local_2.member[2u];
let _e2647 = (_e2635 + _e2646);
let _e2649 = select(_e2610, _e2647, (_e2647 < _e2610));
let _e2654 = global_2.member[bitcast<u32>(select(0i, _e2649, (_e2649 > 0i)))];
let _e2656 = local_3[0u];
let _e2661 = local_3[1u];
let _e2664 = (_e2634 + (((_e2645 + ((bitcast<f32>(_e2654) - _e2645) * _e2656)) - _e2634) * _e2661));
let _e2665 = (_e2593 + _e2590);
let _e2666 = local_2.member[1u];
let _e2667 = (_e2665 + _e2666);
let _e2669 = select(_e2610, _e2667, (_e2667 < _e2610));
let _e2674 = global_2.member[bitcast<u32>(select(0i, _e2669, (_e2669 > 0i)))];
let _e2675 = bitcast<f32>(_e2674);
let _e2676 = local_2.member[2u];
let _e2677 = (_e2665 + _e2676);
let _e2679 = select(_e2610, _e2677, (_e2677 < _e2610));
let _e2684 = global_2.member[bitcast<u32>(select(0i, _e2679, (_e2679 > 0i)))];
let _e2686 = local_3[0u];
let _e2689 = (_e2675 + ((bitcast<f32>(_e2684) - _e2675) * _e2686));
let _e2690 = (_e2593 + _e2591);
let _e2691 = local_2.member[1u];
let _e2692 = (_e2690 + _e2691);
let _e2694 = select(_e2610, _e2692, (_e2692 < _e2610));
let _e2699 = global_2.member[bitcast<u32>(select(0i, _e2694, (_e2694 > 0i)))];
let _e2700 = bitcast<f32>(_e2699);
let _e2701 = local_2.member[2u];
let _e2702 = (_e2690 + _e2701);
let _e2704 = select(_e2610, _e2702, (_e2702 < _e2610));
let _e2709 = global_2.member[bitcast<u32>(select(0i, _e2704, (_e2704 > 0i)))];
let _e2711 = local_3[0u];
let _e2715 = local_3[1u];
let _e2720 = local_3[2u];
let _e2727 = global_1.member.member_6.member_5;
let _e2732 = global_1.member.member_6.member_6;
let _e2733 = (((_e2664 + (((_e2689 + (((_e2700 + ((bitcast<f32>(_e2709) - _e2700) * _e2711)) - _e2689) * _e2715)) - _e2664) * _e2720)) * _e2727) + _e2732);
let _e2735 = select(0f, _e2733, (_e2733 > 0f));
phi_5387_ = type_29(select(1f, _e2735, (_e2735 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2740 = phi_5387_;
let _e2745 = global_1.member.member_6.member_3.member;
let _e2746 = (_e2745 - 0.5f);
let _e2748 = select(-0.5f, _e894, (_e894 > -0.5f));
let _e2750 = select(_e2746, _e2748, (_e2748 < _e2746));
let _e2755 = global_1.member.member_6.member_3.member_1;
let _e2756 = (_e2755 - 0.5f);
let _e2758 = select(-0.5f, _e909, (_e909 > -0.5f));
let _e2760 = select(_e2756, _e2758, (_e2758 < _e2756));
let _e2765 = global_1.member.member_6.member_3.member_2;
let _e2766 = (_e2765 - 0.5f);
let _e2768 = select(-0.5f, _e924, (_e924 > -0.5f));
let _e2770 = select(_e2766, _e2768, (_e2768 < _e2766));
let _e2772 = select(-1f, _e2750, (_e2750 > -1f));
let _e2774 = select(_e2745, _e2772, (_e2772 < _e2745));
let _e2781 = select(0i, select(select(i32(_e2774), i32(-2147483648), (_e2774 < -2147483600f)), 2147483647i, (_e2774 > 2147483500f)), (_e2774 == _e2774));
let _e2785 = (_e2781 - select(0i, 1i, (_e2774 < f32(_e2781))));
let _e2787 = select(-1f, _e2760, (_e2760 > -1f));
let _e2789 = select(_e2755, _e2787, (_e2787 < _e2755));
let _e2796 = select(0i, select(select(i32(_e2789), i32(-2147483648), (_e2789 < -2147483600f)), 2147483647i, (_e2789 > 2147483500f)), (_e2789 == _e2789));
let _e2800 = (_e2796 - select(0i, 1i, (_e2789 < f32(_e2796))));
let _e2802 = select(-1f, _e2770, (_e2770 > -1f));
let _e2804 = select(_e2765, _e2802, (_e2802 < _e2765));
let _e2811 = select(0i, select(select(i32(_e2804), i32(-2147483648), (_e2804 < -2147483600f)), 2147483647i, (_e2804 > 2147483500f)), (_e2804 == _e2804));
let _e2815 = (_e2811 - select(0i, 1i, (_e2804 < f32(_e2811))));
let _e2819 = global_1.member.member_6.member_7;
let _e2823 = global_1.member.member_6.member_8;
let _e2831 = (select(0i, select(select(i32(_e2755), i32(-2147483648), (_e2755 < -2147483600f)), 2147483647i, (_e2755 > 2147483500f)), (_e2755 == _e2755)) - 1i);
let _e2834 = (_e2800 + 1i);
let _e2844 = (select(0i, select(select(i32(_e2765), i32(-2147483648), (_e2765 < -2147483600f)), 2147483647i, (_e2765 > 2147483500f)), (_e2765 == _e2765)) - 1i);
let _e2847 = (_e2815 + 1i);
let _e2857 = (select(0i, select(select(i32(_e2745), i32(-2147483648), (_e2745 < -2147483600f)), 2147483647i, (_e2745 > 2147483500f)), (_e2745 == _e2745)) - 1i);
let _e2858 = (_e2785 - 1i);
let _e2863 = (_e2785 + 1i);
let _e2866 = (_e2785 + 2i);
let _e2869 = (select(0i, _e2800, (_e2800 > 0i)) * _e2819);
let _e2870 = (select(_e2831, _e2834, (_e2834 < _e2831)) * _e2819);
let _e2871 = (select(0i, _e2815, (_e2815 > 0i)) * _e2823);
let _e2872 = (select(_e2844, _e2847, (_e2847 < _e2844)) * _e2823);
local = type_27(array<i32, 4>(select(0i, _e2858, (_e2858 > 0i)), select(0i, _e2785, (_e2785 > 0i)), select(_e2857, _e2863, (_e2863 < _e2857)), select(_e2857, _e2866, (_e2866 < _e2857))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_1 = vec3<f32>((_e2750 - f32(_e2785)), (_e2760 - f32(_e2800)), (_e2770 - f32(_e2815)));
let _e2883 = (_e2871 + _e2869);
let _e2886 = local.member[1u];
let _e2887 = (_e2883 + _e2886);
let _e2889 = (bitcast<i32>(_e88) - 1i);
let _e2891 = select(_e2889, _e2887, (_e2887 < _e2889));
let _e2896 = global_2.member[bitcast<u32>(select(0i, _e2891, (_e2891 > 0i)))];
let _e2897 = bitcast<f32>(_e2896);
let _e2900 = local.member[2u];
let _e2901 = (_e2883 + _e2900);
let _e2903 = select(_e2889, _e2901, (_e2901 < _e2889));
let _e2908 = global_2.member[bitcast<u32>(select(0i, _e2903, (_e2903 > 0i)))];
let _e2910 = local_1[0u];
let _e2913 = (_e2897 + ((bitcast<f32>(_e2908) - _e2897) * _e2910));
let _e2914 = (_e2871 + _e2870);
let _e2915 = local.member[1u];
let _e2916 = (_e2914 + _e2915);
let _e2918 = select(_e2889, _e2916, (_e2916 < _e2889));
let _e2923 = global_2.member[bitcast<u32>(select(0i, _e2918, (_e2918 > 0i)))];
let _e2924 = bitcast<f32>(_e2923);
let _e2925 = local.member[2u];
let _e2926 = (_e2914 + _e2925);
let _e2928 = select(_e2889, _e2926, (_e2926 < _e2889));
let _e2933 = global_2.member[bitcast<u32>(select(0i, _e2928, (_e2928 > 0i)))];
let _e2935 = local_1[0u];
let _e2940 = local_1[1u];
let _e2943 = (_e2913 + (((_e2924 + ((bitcast<f32>(_e2933) - _e2924) * _e2935)) - _e2913) * _e2940));
let _e2944 = (_e2872 + _e2869);
let _e2945 = local.member[1u];
let _e2946 = (_e2944 + _e2945);
let _e2948 = select(_e2889, _e2946, (_e2946 < _e2889));
let _e2953 = global_2.member[bitcast<u32>(select(0i, _e2948, (_e2948 > 0i)))];
let _e2954 = bitcast<f32>(_e2953);
let _e2955 = local.member[2u];
let _e2956 = (_e2944 + _e2955);
let _e2958 = select(_e2889, _e2956, (_e2956 < _e2889));
let _e2963 = global_2.member[bitcast<u32>(select(0i, _e2958, (_e2958 > 0i)))];
let _e2965 = local_1[0u];
let _e2968 = (_e2954 + ((bitcast<f32>(_e2963) - _e2954) * _e2965));
let _e2969 = (_e2872 + _e2870);
let _e2970 = local.member[1u];
let _e2971 = (_e2969 + _e2970);
let _e2973 = select(_e2889, _e2971, (_e2971 < _e2889));
let _e2978 = global_2.member[bitcast<u32>(select(0i, _e2973, (_e2973 > 0i)))];
let _e2979 = bitcast<f32>(_e2978);
let _e2980 = local.member[2u];
let _e2981 = (_e2969 + _e2980);
let _e2983 = select(_e2889, _e2981, (_e2981 < _e2889));
let _e2988 = global_2.member[bitcast<u32>(select(0i, _e2983, (_e2983 > 0i)))];
let _e2990 = local_1[0u];
let _e2994 = local_1[1u];
let _e2999 = local_1[2u];
let _e3006 = global_1.member.member_6.member_5;
let _e3011 = global_1.member.member_6.member_6;
let _e3012 = (((_e2943 + (((_e2968 + (((_e2979 + ((bitcast<f32>(_e2988) - _e2979) * _e2990)) - _e2968) * _e2994)) - _e2943) * _e2999)) * _e3006) + _e3011);
let _e3014 = select(0f, _e3012, (_e3012 > 0f));
let _e3016 = select(1f, _e3014, (_e3014 < 1f));
let _e3019 = global_1.member.member_1;
if ((_e3019 & 16u) == 0u) {
phi_6220_ = type_5(1f, 1f, 1f);
} else {
let _e3025 = global_1.member.member_14.member;
let _e3036 = ((((_e3025.member.member * _e851) + (_e3025.member.member_1 * _e864)) + (_e3025.member.member_2 * _e829)) + _e3025.member_1);
let _e3042 = ((((_e3025.member.member * _e874) + (_e3025.member.member_1 * _e879)) + (_e3025.member.member_2 * _e868)) + _e3025.member_1);
let _e3044 = select(_e3042, _e3036, (_e3036 < _e3042));
let _e3046 = select(_e3042, _e3036, (_e3036 > _e3042));
let _e3048 = (_e3046 - _e3044);
let _e3051 = (-(_e3044) / select(1e-30f, _e3048, (_e3048 > 1e-30f)));
let _e3053 = select(0f, _e3051, (_e3051 > 0f));
let _e3059 = select(select(select(1f, _e3053, (_e3053 < 1f)), 1f, (_e3046 <= 0f)), 0f, (_e3044 > 0f));
let _e3064 = global_1.member.member_14.member_1;
let _e3065 = (_e3064 != 0u);
let _e3075 = global_1.member.member_15.member;
let _e3086 = ((((_e3075.member.member * _e851) + (_e3075.member.member_1 * _e864)) + (_e3075.member.member_2 * _e829)) + _e3075.member_1);
let _e3092 = ((((_e3075.member.member * _e874) + (_e3075.member.member_1 * _e879)) + (_e3075.member.member_2 * _e868)) + _e3075.member_1);
let _e3094 = select(_e3092, _e3086, (_e3086 < _e3092));
let _e3096 = select(_e3092, _e3086, (_e3086 > _e3092));
let _e3098 = (_e3096 - _e3094);
let _e3101 = (-(_e3094) / select(1e-30f, _e3098, (_e3098 > 1e-30f)));
let _e3103 = select(0f, _e3101, (_e3101 > 0f));
let _e3109 = select(select(select(1f, _e3103, (_e3103 < 1f)), 1f, (_e3096 <= 0f)), 0f, (_e3094 > 0f));
let _e3114 = global_1.member.member_15.member_1;
let _e3115 = (_e3114 != 0u);
let _e3125 = global_1.member.member_16.member;
let _e3136 = ((((_e3125.member.member * _e851) + (_e3125.member.member_1 * _e864)) + (_e3125.member.member_2 * _e829)) + _e3125.member_1);
let _e3142 = ((((_e3125.member.member * _e874) + (_e3125.member.member_1 * _e879)) + (_e3125.member.member_2 * _e868)) + _e3125.member_1);
let _e3144 = select(_e3142, _e3136, (_e3136 < _e3142));
let _e3146 = select(_e3142, _e3136, (_e3136 > _e3142));
let _e3148 = (_e3146 - _e3144);
let _e3151 = (-(_e3144) / select(1e-30f, _e3148, (_e3148 > 1e-30f)));
let _e3153 = select(0f, _e3151, (_e3151 > 0f));
let _e3159 = select(select(select(1f, _e3153, (_e3153 < 1f)), 1f, (_e3146 <= 0f)), 0f, (_e3144 > 0f));
let _e3164 = global_1.member.member_16.member_1;
let _e3165 = (_e3164 != 0u);
let _e3175 = global_1.member.member_17.member;
let _e3186 = ((((_e3175.member.member * _e851) + (_e3175.member.member_1 * _e864)) + (_e3175.member.member_2 * _e829)) + _e3175.member_1);
let _e3192 = ((((_e3175.member.member * _e874) + (_e3175.member.member_1 * _e879)) + (_e3175.member.member_2 * _e868)) + _e3175.member_1);
let _e3194 = select(_e3192, _e3186, (_e3186 < _e3192));
let _e3196 = select(_e3192, _e3186, (_e3186 > _e3192));
let _e3198 = (_e3196 - _e3194);
let _e3201 = (-(_e3194) / select(1e-30f, _e3198, (_e3198 > 1e-30f)));
let _e3203 = select(0f, _e3201, (_e3201 > 0f));
let _e3209 = select(select(select(1f, _e3203, (_e3203 < 1f)), 1f, (_e3196 <= 0f)), 0f, (_e3194 > 0f));
let _e3214 = global_1.member.member_17.member_1;
let _e3215 = (_e3214 != 0u);
phi_6220_ = type_5(((((1f * _e3059) * _e3109) * _e3159) * _e3209), ((((1f * select(1f, _e3059, _e3065)) * select(1f, _e3109, _e3115)) * select(1f, _e3159, _e3165)) * select(1f, _e3209, _e3215)), ((((1f * select(1f, 0f, (_e3065 && (_e3042 > 0f)))) * select(1f, 0f, (_e3115 && (_e3092 > 0f)))) * select(1f, 0f, (_e3165 && (_e3142 > 0f)))) * select(1f, 0f, (_e3215 && (_e3192 > 0f)))));
}
let _e3224 = phi_6220_;
let _e3225 = (_e930 - _e894);
let _e3229 = (bitcast<f32>((bitcast<u32>(_e3225) & 2147483647u)) < 1e-12f);
let _e3231 = (1f / select(_e3225, 1f, _e3229));
let _e3233 = ((-0.5f - _e894) * _e3231);
let _e3235 = ((_e2746 - _e894) * _e3231);
let _e3241 = select(_e3235, _e3233, (_e3233 < _e3235));
let _e3243 = select(0f, _e3241, (_e3241 > 0f));
let _e3246 = select(select(1f, _e3243, (_e3243 < 1f)), select(2f, 0f, ((_e894 >= -0.5f) && (_e894 <= _e2746))), _e3229);
let _e3248 = select(_e3235, _e3233, (_e3233 > _e3235));
let _e3250 = select(0f, _e3248, (_e3248 > 0f));
let _e3253 = select(select(1f, _e3250, (_e3250 < 1f)), 1f, _e3229);
let _e3254 = (_e936 - _e909);
let _e3258 = (bitcast<f32>((bitcast<u32>(_e3254) & 2147483647u)) < 1e-12f);
let _e3260 = (1f / select(_e3254, 1f, _e3258));
let _e3262 = ((-0.5f - _e909) * _e3260);
let _e3264 = ((_e2756 - _e909) * _e3260);
let _e3270 = select(_e3264, _e3262, (_e3262 < _e3264));
let _e3272 = select(0f, _e3270, (_e3270 > 0f));
let _e3275 = select(select(1f, _e3272, (_e3272 < 1f)), select(2f, 0f, ((_e909 >= -0.5f) && (_e909 <= _e2756))), _e3258);
let _e3277 = select(_e3264, _e3262, (_e3262 > _e3264));
let _e3279 = select(0f, _e3277, (_e3277 > 0f));
let _e3282 = select(select(1f, _e3279, (_e3279 < 1f)), 1f, _e3258);
let _e3283 = (_e942 - _e924);
let _e3287 = (bitcast<f32>((bitcast<u32>(_e3283) & 2147483647u)) < 1e-12f);
let _e3289 = (1f / select(_e3283, 1f, _e3287));
let _e3291 = ((-0.5f - _e924) * _e3289);
let _e3293 = ((_e2766 - _e924) * _e3289);
let _e3299 = select(_e3293, _e3291, (_e3291 < _e3293));
let _e3301 = select(0f, _e3299, (_e3299 > 0f));
let _e3304 = select(select(1f, _e3301, (_e3301 < 1f)), select(2f, 0f, ((_e924 >= -0.5f) && (_e924 <= _e2766))), _e3287);
let _e3306 = select(_e3293, _e3291, (_e3291 > _e3293));
let _e3308 = select(0f, _e3306, (_e3306 > 0f));
let _e3311 = select(select(1f, _e3308, (_e3308 < 1f)), 1f, _e3287);
let _e3313 = select(_e3282, _e3253, (_e3253 < _e3282));
let _e3317 = select(_e3275, _e3246, (_e3246 > _e3275));
let _e3320 = (select(_e3311, _e3313, (_e3313 < _e3311)) - select(_e3304, _e3317, (_e3317 > _e3304)));
let _e3323 = (_e874 - _e851);
let _e3324 = (_e879 - _e864);
let _e3325 = (_e868 - _e829);
let _e3330 = (((_e3323 * _e3323) + (_e3324 * _e3324)) + (_e3325 * _e3325));
let _e3338 = global_1.member.member_5.member_3;
let _e3339 = ((sqrt(select(0f, _e3330, (_e3330 > 0f))) * select(0f, _e3320, (_e3320 > 0f))) * _e3338);
if (_e105.member_2 >= 3u) {
let _e3342 = (_e3016 * 255f);
let _e3343 = (_e2740.member * 255f);
let _e3344 = (255f - 1f);
let _e3346 = select(0f, _e3342, (_e3342 > 0f));
let _e3348 = select(_e3344, _e3346, (_e3346 < _e3344));
let _e3355 = select(0i, select(select(i32(_e3348), i32(-2147483648), (_e3348 < -2147483600f)), 2147483647i, (_e3348 > 2147483500f)), (_e3348 == _e3348));
let _e3359 = (_e3355 - select(0i, 1i, (_e3348 < f32(_e3355))));
let _e3361 = select(0f, _e3343, (_e3343 > 0f));
let _e3363 = select(_e3344, _e3361, (_e3361 < _e3344));
let _e3370 = select(0i, select(select(i32(_e3363), i32(-2147483648), (_e3363 < -2147483600f)), 2147483647i, (_e3363 > 2147483500f)), (_e3363 == _e3363));
let _e3374 = (_e3370 - select(0i, 1i, (_e3363 < f32(_e3370))));
let _e3377 = (((_e3359 * 256i) + _e3374) * 4i);
let _e3381 = (_e3343 - f32(_e3374));
let _e3383 = (bitcast<i32>(_e95) - 1i);
let _e3385 = select(_e3383, _e3377, (_e3377 < _e3383));
let _e3391 = global_4.member[bitcast<u32>(select(0i, _e3385, (_e3385 > 0i)))];
let _e3392 = (_e3377 + 4i);
let _e3394 = select(_e3383, _e3392, (_e3392 < _e3383));
let _e3400 = global_4.member[bitcast<u32>(select(0i, _e3394, (_e3394 > 0i)))];
let _e3401 = (_e3377 + 1024i);
let _e3403 = select(_e3383, _e3401, (_e3401 < _e3383));
let _e3409 = global_4.member[bitcast<u32>(select(0i, _e3403, (_e3403 > 0i)))];
let _e3410 = (_e3377 + 1028i);
let _e3412 = select(_e3383, _e3410, (_e3410 < _e3383));
let _e3418 = global_4.member[bitcast<u32>(select(0i, _e3412, (_e3412 > 0i)))];
let _e3423 = (bitcast<f32>(((_e3391 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3431 = (_e3423 + (((bitcast<f32>(((_e3400 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3423) * _e3381));
let _e3436 = (bitcast<f32>(((_e3409 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3447 = (_e3431 + (((_e3436 + (((bitcast<f32>(((_e3418 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3436) * _e3381)) - _e3431) * (_e3342 - f32(_e3359))));
let _e3451 = -((_e3447 * (_e3339 * _e3224.member)));
let _e3453 = select(-87f, _e3451, (_e3451 > -87f));
let _e3455 = select(88f, _e3453, (_e3453 < 88f));
let _e3457 = ((_e3455 * 1.442695f) + 0.5f);
let _e3459 = select(-127f, _e3457, (_e3457 > -127f));
let _e3461 = select(128f, _e3459, (_e3459 < 128f));
let _e3468 = select(0i, select(select(i32(_e3461), i32(-2147483648), (_e3461 < -2147483600f)), 2147483647i, (_e3461 > 2147483500f)), (_e3461 == _e3461));
let _e3472 = (_e3468 - select(0i, 1i, (_e3461 < f32(_e3468))));
let _e3473 = f32(_e3472);
let _e3477 = ((_e3455 - (_e3473 * 0.6933594f)) - (_e3473 * -2.1219444e-4f));
let _e3497 = ((1f + (_e3477 * (1f + (_e3477 * (0.5f + (_e3477 * (0.16666667f + (_e3477 * (0.041666668f + (_e3477 * (0.008333334f + (_e3477 * (0.001388889f + (_e3477 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3472 + 127i)) << bitcast<u32>(23i))));
let _e3498 = (1f - _e3497);
phi_7330_ = type_30(_e3497, _e3498, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e3498 / select(1e-12f, _e3447, (_e3447 > 1e-12f))))));
} else {
let _e3506 = (_e3016 * 255f);
let _e3507 = (_e2740.member * 255f);
let _e3508 = (255f - 1f);
let _e3510 = select(0f, _e3506, (_e3506 > 0f));
let _e3512 = select(_e3508, _e3510, (_e3510 < _e3508));
let _e3519 = select(0i, select(select(i32(_e3512), i32(-2147483648), (_e3512 < -2147483600f)), 2147483647i, (_e3512 > 2147483500f)), (_e3512 == _e3512));
let _e3523 = (_e3519 - select(0i, 1i, (_e3512 < f32(_e3519))));
let _e3525 = select(0f, _e3507, (_e3507 > 0f));
let _e3527 = select(_e3508, _e3525, (_e3525 < _e3508));
let _e3534 = select(0i, select(select(i32(_e3527), i32(-2147483648), (_e3527 < -2147483600f)), 2147483647i, (_e3527 > 2147483500f)), (_e3527 == _e3527));
let _e3538 = (_e3534 - select(0i, 1i, (_e3527 < f32(_e3534))));
let _e3541 = (((_e3523 * 256i) + _e3538) * 4i);
let _e3543 = (_e3506 - f32(_e3523));
let _e3545 = (_e3507 - f32(_e3538));
let _e3547 = (bitcast<i32>(_e95) - 1i);
let _e3549 = select(_e3547, _e3541, (_e3541 < _e3547));
let _e3555 = global_4.member[bitcast<u32>(select(0i, _e3549, (_e3549 > 0i)))];
let _e3556 = (_e3541 + 4i);
let _e3558 = select(_e3547, _e3556, (_e3556 < _e3547));
let _e3564 = global_4.member[bitcast<u32>(select(0i, _e3558, (_e3558 > 0i)))];
let _e3565 = (_e3541 + 1024i);
let _e3567 = select(_e3547, _e3565, (_e3565 < _e3547));
let _e3573 = global_4.member[bitcast<u32>(select(0i, _e3567, (_e3567 > 0i)))];
let _e3574 = (_e3541 + 1028i);
let _e3576 = select(_e3547, _e3574, (_e3574 < _e3547));
let _e3582 = global_4.member[bitcast<u32>(select(0i, _e3576, (_e3576 > 0i)))];
let _e3587 = (bitcast<f32>(((_e3555 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3595 = (_e3587 + (((bitcast<f32>(((_e3564 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3587) * _e3545));
let _e3600 = (bitcast<f32>(((_e3573 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3611 = (_e3595 + (((_e3600 + (((bitcast<f32>(((_e3582 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3600) * _e3545)) - _e3595) * _e3543));
let _e3624 = (bitcast<f32>((((_e3555 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3632 = (_e3624 + (((bitcast<f32>((((_e3564 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3624) * _e3545));
let _e3637 = (bitcast<f32>((((_e3573 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3649 = (_e3541 + 1i);
let _e3651 = select(_e3547, _e3649, (_e3649 < _e3547));
let _e3657 = global_4.member[bitcast<u32>(select(0i, _e3651, (_e3651 > 0i)))];
let _e3658 = (_e3541 + 5i);
let _e3660 = select(_e3547, _e3658, (_e3658 < _e3547));
let _e3666 = global_4.member[bitcast<u32>(select(0i, _e3660, (_e3660 > 0i)))];
let _e3667 = (_e3541 + 1025i);
let _e3669 = select(_e3547, _e3667, (_e3667 < _e3547));
let _e3675 = global_4.member[bitcast<u32>(select(0i, _e3669, (_e3669 > 0i)))];
let _e3676 = (_e3541 + 1029i);
let _e3678 = select(_e3547, _e3676, (_e3676 < _e3547));
let _e3684 = global_4.member[bitcast<u32>(select(0i, _e3678, (_e3678 > 0i)))];
let _e3689 = (bitcast<f32>(((_e3657 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3697 = (_e3689 + (((bitcast<f32>(((_e3666 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3689) * _e3545));
let _e3702 = (bitcast<f32>(((_e3675 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3726 = (bitcast<f32>((((_e3657 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3734 = (_e3726 + (((bitcast<f32>((((_e3666 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3726) * _e3545));
let _e3739 = (bitcast<f32>((((_e3675 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3754 = (_e3339 * _e3224.member_1);
let _e3756 = -(((_e3632 + (((_e3637 + (((bitcast<f32>((((_e3582 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3637) * _e3545)) - _e3632) * _e3543)) * _e3754));
let _e3758 = select(-87f, _e3756, (_e3756 > -87f));
let _e3760 = select(88f, _e3758, (_e3758 < 88f));
let _e3762 = ((_e3760 * 1.442695f) + 0.5f);
let _e3764 = select(-127f, _e3762, (_e3762 > -127f));
let _e3766 = select(128f, _e3764, (_e3764 < 128f));
let _e3773 = select(0i, select(select(i32(_e3766), i32(-2147483648), (_e3766 < -2147483600f)), 2147483647i, (_e3766 > 2147483500f)), (_e3766 == _e3766));
let _e3777 = (_e3773 - select(0i, 1i, (_e3766 < f32(_e3773))));
let _e3778 = f32(_e3777);
let _e3782 = ((_e3760 - (_e3778 * 0.6933594f)) - (_e3778 * -2.1219444e-4f));
let _e3804 = -(((_e3697 + (((_e3702 + (((bitcast<f32>(((_e3684 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3702) * _e3545)) - _e3697) * _e3543)) * _e3754));
let _e3806 = select(-87f, _e3804, (_e3804 > -87f));
let _e3808 = select(88f, _e3806, (_e3806 < 88f));
let _e3810 = ((_e3808 * 1.442695f) + 0.5f);
let _e3812 = select(-127f, _e3810, (_e3810 > -127f));
let _e3814 = select(128f, _e3812, (_e3812 < 128f));
let _e3821 = select(0i, select(select(i32(_e3814), i32(-2147483648), (_e3814 < -2147483600f)), 2147483647i, (_e3814 > 2147483500f)), (_e3814 == _e3814));
let _e3825 = (_e3821 - select(0i, 1i, (_e3814 < f32(_e3821))));
let _e3826 = f32(_e3825);
let _e3830 = ((_e3808 - (_e3826 * 0.6933594f)) - (_e3826 * -2.1219444e-4f));
let _e3852 = -(((_e3734 + (((_e3739 + (((bitcast<f32>((((_e3684 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3739) * _e3545)) - _e3734) * _e3543)) * _e3754));
let _e3854 = select(-87f, _e3852, (_e3852 > -87f));
let _e3856 = select(88f, _e3854, (_e3854 < 88f));
let _e3858 = ((_e3856 * 1.442695f) + 0.5f);
let _e3860 = select(-127f, _e3858, (_e3858 > -127f));
let _e3862 = select(128f, _e3860, (_e3860 < 128f));
let _e3869 = select(0i, select(select(i32(_e3862), i32(-2147483648), (_e3862 < -2147483600f)), 2147483647i, (_e3862 > 2147483500f)), (_e3862 == _e3862));
let _e3873 = (_e3869 - select(0i, 1i, (_e3862 < f32(_e3869))));
let _e3874 = f32(_e3873);
let _e3878 = ((_e3856 - (_e3874 * 0.6933594f)) - (_e3874 * -2.1219444e-4f));
let _e3901 = -((_e3611 * (_e3339 * _e3224.member)));
let _e3903 = select(-87f, _e3901, (_e3901 > -87f));
let _e3905 = select(88f, _e3903, (_e3903 < 88f));
let _e3907 = ((_e3905 * 1.442695f) + 0.5f);
let _e3909 = select(-127f, _e3907, (_e3907 > -127f));
let _e3911 = select(128f, _e3909, (_e3909 < 128f));
let _e3918 = select(0i, select(select(i32(_e3911), i32(-2147483648), (_e3911 < -2147483600f)), 2147483647i, (_e3911 > 2147483500f)), (_e3911 == _e3911));
let _e3922 = (_e3918 - select(0i, 1i, (_e3911 < f32(_e3918))));
let _e3923 = f32(_e3922);
let _e3927 = ((_e3905 - (_e3923 * 0.6933594f)) - (_e3923 * -2.1219444e-4f));
let _e3947 = ((1f + (_e3927 * (1f + (_e3927 * (0.5f + (_e3927 * (0.16666667f + (_e3927 * (0.041666668f + (_e3927 * (0.008333334f + (_e3927 * (0.001388889f + (_e3927 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3922 + 127i)) << bitcast<u32>(23i))));
let _e3948 = (1f - _e3947);
phi_7330_ = type_30(_e3947, _e3948, vec3<f32>(((1f + (_e3782 * (1f + (_e3782 * (0.5f + (_e3782 * (0.16666667f + (_e3782 * (0.041666668f + (_e3782 * (0.008333334f + (_e3782 * (0.001388889f + (_e3782 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3777 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3830 * (1f + (_e3830 * (0.5f + (_e3830 * (0.16666667f + (_e3830 * (0.041666668f + (_e3830 * (0.008333334f + (_e3830 * (0.001388889f + (_e3830 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3825 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3878 * (1f + (_e3878 * (0.5f + (_e3878 * (0.16666667f + (_e3878 * (0.041666668f + (_e3878 * (0.008333334f + (_e3878 * (0.001388889f + (_e3878 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3873 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e3948 / select(1e-12f, _e3611, (_e3611 > 1e-12f))))));
}
let _e3956 = phi_7330_;
if _e992 {
let _e3960 = global_1.member.member_5.member_2;
let _e3968 = global_1.member.member_5.member_4;
let _e3971 = (_e2740.member_3.x * _e3224.member_2);
let _e3973 = (_e2740.member_3.y * _e3224.member_2);
let _e3975 = (_e2740.member_3.z * _e3224.member_2);
let _e3976 = (0.5f * (_e3960 / select(1e-6f, _e185, (_e185 > 1e-6f))));
let _e3980 = (_e163 + (_e3971 * _e3976));
let _e3981 = (_e174 + (_e3973 * _e3976));
let _e3982 = (_e185 + (_e3975 * _e3976));
let _e3984 = (2f * _e3960);
let _e3986 = ((_e3982 * _e3982) + (_e3984 * _e3975));
let _e3990 = (_e3982 + sqrt(select(0f, _e3986, (_e3986 > 0f))));
let _e3994 = (0.5f * (_e3984 / select(1e-6f, _e3990, (_e3990 > 1e-6f))));
let _e3998 = (_e3980 + (_e3971 * _e3994));
let _e3999 = (_e3981 + (_e3973 * _e3994));
let _e4000 = (_e3982 + (_e3975 * _e3994));
let _e4004 = (_e3968 * _e3968);
let _e4006 = (_e4000 * _e4000);
let _e4014 = (((_e3982 <= 0f) || (_e3986 <= 0f)) || ((_e4000 <= 0f) || (_e4006 <= (_e4004 * (((_e3998 * _e3998) + (_e3999 * _e3999)) + _e4006)))));
let _e4028 = (_e163 + ((_e2740.member_4.x * _e3224.member_2) * _e3960));
let _e4029 = (_e174 + ((_e2740.member_4.y * _e3224.member_2) * _e3960));
let _e4030 = (_e185 + ((_e2740.member_4.z * _e3224.member_2) * _e3960));
let _e4032 = (_e4030 * _e4030);
let _e4041 = ((_e3019 & 1u) != 0u);
let _e4045 = select(_e4014, ((_e4030 <= 0f) || (_e4032 <= (_e4004 * (((_e4028 * _e4028) + (_e4029 * _e4029)) + _e4032)))), _e4041);
phi_7481_ = select(select(select(_e4000, _e3982, _e4014), _e4030, _e4041), _e185, _e4045);
phi_7482_ = select(select(select(_e3999, _e3981, _e4014), _e4029, _e4041), _e174, _e4045);
phi_7483_ = select(select(select(_e3998, _e3980, _e4014), _e4028, _e4041), _e163, _e4045);
phi_7484_ = select(1f, 0f, _e4045);
} else {
phi_7481_ = _e185;
phi_7482_ = _e174;
phi_7483_ = _e163;
phi_7484_ = 1f;
}
let _e4051 = phi_7481_;
let _e4053 = phi_7482_;
let _e4055 = phi_7483_;
let _e4057 = phi_7484_;
let _e4060 = (_e3956.member * _e4057);
global_5.member[_e120] = (_e131 * (_e3956.member_2.x * _e4060));
global_5.member[_e132] = (_e141 * (_e3956.member_2.y * _e4060));
global_5.member[_e143] = (_e152 * (_e3956.member_2.z * _e4060));
global_5.member[_e154] = _e4055;
global_5.member[_e165] = _e4053;
global_5.member[_e176] = _e4051;
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
