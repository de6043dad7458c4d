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
struct type_16 {
member: array<u32>,
}
struct type_17 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_18 {
member: u32,
member_1: u32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_20 {
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
struct type_21 {
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
struct type_22 {
member: type_5,
member_1: type_5,
}
struct type_23 {
member: type_7,
member_1: u32,
}
struct type_24 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_18,
member_4: u32,
member_5: type_19,
member_6: type_20,
member_7: type_20,
member_8: type_21,
member_9: type_22,
member_10: f32,
member_11: type_19,
member_12: type_4,
member_13: type_9,
member_14: type_23,
member_15: type_23,
member_16: type_23,
member_17: type_23,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_25 {
member: type_24,
}
struct type_28 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_29 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_30 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
struct type_31 {
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(3)
var<storage> global_3: type_16;
@group(0) @binding(4)
var<storage> global_4: type_16;
@group(0) @binding(6)
var<storage, read_write> global_5: type_11;
@group(0) @binding(5)
var<storage> global_6: type_11;
fn function_() {
var local: type_28;
var local_1: vec3<f32>;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var phi_936_: u32;
var phi_3190_: type_29;
var phi_3836_: type_30;
var phi_4669_: type_5;
var phi_5779_: type_31;
var phi_5930_: f32;
var phi_5931_: f32;
var phi_5932_: f32;
var phi_5933_: f32;
let _e83 = global;
let _e86 = arrayLength((&global_2.member));
let _e90 = arrayLength((&global_4.member));
let _e92 = arrayLength((&global_6.member));
let _e97 = global_1.member.member_2;
let _e100 = global_1.member.member;
let _e108 = (_e83.x + _e97.member);
let _e110 = (_e83.y + _e97.member_1);
if (_e108 < _e97.member_2) {
if (_e110 < _e97.member_3) {
let _e113 = (_e100.member * _e100.member_1);
let _e115 = ((_e110 * _e100.member) + _e108);
let _e116 = bitcast<i32>(_e115);
let _e118 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e120 = select(_e118, _e116, (_e116 < _e118));
let _e126 = global_5.member[bitcast<u32>(select(0i, _e120, (_e120 > 0i)))];
let _e127 = (_e113 + _e115);
let _e128 = bitcast<i32>(_e127);
let _e130 = select(_e118, _e128, (_e128 < _e118));
let _e136 = global_5.member[bitcast<u32>(select(0i, _e130, (_e130 > 0i)))];
let _e138 = ((2u * _e113) + _e115);
let _e139 = bitcast<i32>(_e138);
let _e141 = select(_e118, _e139, (_e139 < _e118));
let _e147 = global_5.member[bitcast<u32>(select(0i, _e141, (_e141 > 0i)))];
let _e149 = ((3u * _e113) + _e115);
let _e150 = bitcast<i32>(_e149);
let _e152 = select(_e118, _e150, (_e150 < _e118));
let _e158 = global_5.member[bitcast<u32>(select(0i, _e152, (_e152 > 0i)))];
let _e160 = ((4u * _e113) + _e115);
let _e161 = bitcast<i32>(_e160);
let _e163 = select(_e118, _e161, (_e161 < _e118));
let _e169 = global_5.member[bitcast<u32>(select(0i, _e163, (_e163 > 0i)))];
let _e171 = ((5u * _e113) + _e115);
let _e172 = bitcast<i32>(_e171);
let _e174 = select(_e118, _e172, (_e172 < _e118));
let _e180 = global_5.member[bitcast<u32>(select(0i, _e174, (_e174 > 0i)))];
let _e182 = ((6u * _e113) + _e115);
let _e183 = bitcast<i32>(_e182);
let _e185 = select(_e118, _e183, (_e183 < _e118));
let _e191 = global_5.member[bitcast<u32>(select(0i, _e185, (_e185 > 0i)))];
let _e193 = ((7u * _e113) + _e115);
let _e194 = bitcast<i32>(_e193);
let _e196 = select(_e118, _e194, (_e194 < _e118));
let _e202 = global_5.member[bitcast<u32>(select(0i, _e196, (_e196 > 0i)))];
let _e204 = ((8u * _e113) + _e115);
let _e205 = bitcast<i32>(_e204);
let _e207 = select(_e118, _e205, (_e205 < _e118));
let _e213 = global_5.member[bitcast<u32>(select(0i, _e207, (_e207 > 0i)))];
let _e217 = global_1.member.member_8.member;
let _e221 = global_1.member.member_8.member_1;
let _e222 = (_e217 * _e221);
if (_e92 >= (_e222 * 2u)) {
let _e226 = bitcast<i32>((_e110 * _e217));
let _e228 = bitcast<i32>(_e108);
let _e233 = global_6.member[bitcast<u32>((_e226 + _e228))];
let _e239 = global_6.member[bitcast<u32>(((bitcast<i32>(_e222) + _e226) + _e228))];
let _e240 = f32(_e228);
let _e242 = f32(bitcast<i32>(_e110));
let _e248 = global_1.member.member_5.member;
let _e252 = global_1.member.member_8.member_8;
let _e253 = (_e248 - _e252);
let _e257 = global_1.member.member_8.member_2;
let _e261 = global_1.member.member_8.member_6;
let _e268 = global_1.member.member_8.member_4;
let _e270 = ((_e257 + (_e261 * _e253)) + (((_e240 - _e233) + 0.5f) * _e268));
let _e274 = global_1.member.member_8.member_3;
let _e278 = global_1.member.member_8.member_7;
let _e283 = ((_e274 + (_e278 * _e253)) + (((_e242 - _e239) + 0.5f) * _e268));
let _e287 = global_1.member.member_5.member_1;
let _e288 = (_e287 - _e252);
let _e293 = ((_e257 + (_e261 * _e288)) + ((_e240 + 0.5f) * _e268));
let _e298 = ((_e274 + (_e278 * _e288)) + ((_e242 + 0.5f) * _e268));
let _e302 = global_1.member.member_6.member;
let _e313 = ((((_e302.member.member * _e270) + (_e302.member.member_1 * _e283)) + (_e302.member.member_2 * _e248)) + _e302.member_1);
let _e317 = global_1.member.member_6.member_1;
let _e328 = ((((_e317.member.member * _e270) + (_e317.member.member_1 * _e283)) + (_e317.member.member_2 * _e248)) + _e317.member_1);
let _e332 = global_1.member.member_6.member_2;
let _e343 = ((((_e332.member.member * _e270) + (_e332.member.member_1 * _e283)) + (_e332.member.member_2 * _e248)) + _e332.member_1);
let _e349 = ((((_e302.member.member * _e293) + (_e302.member.member_1 * _e298)) + (_e302.member.member_2 * _e287)) + _e302.member_1);
let _e355 = ((((_e317.member.member * _e293) + (_e317.member.member_1 * _e298)) + (_e317.member.member_2 * _e287)) + _e317.member_1);
let _e361 = ((((_e332.member.member * _e293) + (_e332.member.member_1 * _e298)) + (_e332.member.member_2 * _e287)) + _e332.member_1);
let _e367 = global_1.member.member_6.member_3.member;
let _e368 = (_e367 - 1f);
let _e377 = global_1.member.member_6.member_3.member_1;
let _e378 = (_e377 - 1f);
let _e387 = global_1.member.member_6.member_3.member_2;
let _e388 = (_e387 - 1f);
let _e407 = global_1.member.member_6.member_4;
let _e408 = (_e367 - 0.5f);
let _e410 = select(-0.5f, _e349, (_e349 > -0.5f));
let _e412 = select(_e408, _e410, (_e410 < _e408));
let _e413 = (_e377 - 0.5f);
let _e415 = select(-0.5f, _e355, (_e355 > -0.5f));
let _e417 = select(_e413, _e415, (_e415 < _e413));
let _e418 = (_e387 - 0.5f);
let _e420 = select(-0.5f, _e361, (_e361 > -0.5f));
let _e422 = select(_e418, _e420, (_e420 < _e418));
let _e428 = bitcast<f32>((bitcast<u32>((_e349 - _e313)) & 2147483647u));
let _e431 = bitcast<f32>((bitcast<u32>((_e355 - _e328)) & 2147483647u));
let _e433 = select(_e431, _e428, (_e428 > _e431));
let _e436 = bitcast<f32>((bitcast<u32>((_e361 - _e343)) & 2147483647u));
let _e445 = bitcast<f32>((bitcast<u32>((_e349 - _e412)) & 2147483647u));
let _e448 = bitcast<f32>((bitcast<u32>((_e355 - _e417)) & 2147483647u));
let _e450 = select(_e448, _e445, (_e445 > _e448));
let _e453 = bitcast<f32>((bitcast<u32>((_e361 - _e422)) & 2147483647u));
let _e457 = (_e412 + 0.5f);
let _e459 = select(0f, _e457, (_e457 > 0f));
let _e461 = select(_e368, _e459, (_e459 < _e368));
let _e468 = select(0i, select(select(i32(_e461), i32(-2147483648), (_e461 < -2147483600f)), 2147483647i, (_e461 > 2147483500f)), (_e461 == _e461));
let _e476 = global_1.member.member_6.member_12;
let _e477 = (_e476 & 31u);
let _e480 = (_e417 + 0.5f);
let _e482 = select(0f, _e480, (_e480 > 0f));
let _e484 = select(_e378, _e482, (_e482 < _e378));
let _e491 = select(0i, select(select(i32(_e484), i32(-2147483648), (_e484 < -2147483600f)), 2147483647i, (_e484 > 2147483500f)), (_e484 == _e484));
let _e498 = (_e422 + 0.5f);
let _e500 = select(0f, _e498, (_e498 > 0f));
let _e502 = select(_e388, _e500, (_e500 < _e388));
let _e509 = select(0i, select(select(i32(_e502), i32(-2147483648), (_e502 < -2147483600f)), 2147483647i, (_e502 > 2147483500f)), (_e502 == _e502));
let _e520 = global_1.member.member_6.member_9.member;
let _e526 = global_1.member.member_6.member_9.member_1;
let _e531 = global_1.member.member_6.member_10;
let _e537 = ((bitcast<i32>(_e531) + ((_e468 - select(0i, 1i, (_e461 < f32(_e468)))) >> bitcast<u32>(_e477))) + (bitcast<i32>(_e520) * (((_e491 - select(0i, 1i, (_e484 < f32(_e491)))) >> bitcast<u32>(_e477)) + (bitcast<i32>(_e526) * ((_e509 - select(0i, 1i, (_e502 < f32(_e509)))) >> bitcast<u32>(_e477))))));
let _e539 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e541 = select(_e539, _e537, (_e537 < _e539));
let _e547 = global_3.member[bitcast<u32>(select(0i, _e541, (_e541 > 0i)))];
let _e553 = global_1.member.member_1;
phi_936_ = select(select(7u, 3u, (((((((_e313 >= 0f) && (_e313 <= _e368)) && (_e328 >= 0f)) && (_e328 <= _e378)) && (_e343 >= 0f)) && (_e343 <= _e388)) && ((((((_e349 >= 0f) && (_e349 <= _e368)) && (_e355 >= 0f)) && (_e355 <= _e378)) && (_e361 >= 0f)) && (_e361 <= _e388)))), 1u, (((_e553 & 64u) != 0u) || ((((select(_e436, _e433, (_e433 > _e436)) <= _e407) && ((select(_e453, _e450, (_e450 > _e453)) > _e407) || (_e547 != 0u))) && true) && ((_e553 & 32u) != 0u))));
} else {
phi_936_ = 7u;
}
let _e563 = phi_936_;
if (_e563 > 1u) {
let _e568 = bitcast<i32>(((_e110 * _e217) + _e108));
let _e571 = (bitcast<i32>(_e92) - 1i);
let _e573 = select(_e571, _e568, (_e568 < _e571));
let _e579 = global_6.member[bitcast<u32>(select(0i, _e573, (_e573 > 0i)))];
let _e580 = (bitcast<i32>(_e222) + _e568);
let _e582 = select(_e571, _e580, (_e580 < _e571));
let _e588 = global_6.member[bitcast<u32>(select(0i, _e582, (_e582 > 0i)))];
let _e590 = f32(bitcast<i32>(_e108));
let _e592 = f32(bitcast<i32>(_e110));
let _e598 = global_1.member.member_5.member;
let _e602 = global_1.member.member_8.member_8;
let _e603 = (_e598 - _e602);
let _e607 = global_1.member.member_8.member_2;
let _e611 = global_1.member.member_8.member_6;
let _e618 = global_1.member.member_8.member_4;
let _e620 = ((_e607 + (_e611 * _e603)) + (((_e590 - _e579) + 0.5f) * _e618));
let _e624 = global_1.member.member_8.member_3;
let _e628 = global_1.member.member_8.member_7;
let _e633 = ((_e624 + (_e628 * _e603)) + (((_e592 - _e588) + 0.5f) * _e618));
let _e637 = global_1.member.member_5.member_1;
let _e638 = (_e637 - _e602);
let _e643 = ((_e607 + (_e611 * _e638)) + ((_e590 + 0.5f) * _e618));
let _e648 = ((_e624 + (_e628 * _e638)) + ((_e592 + 0.5f) * _e618));
let _e652 = global_1.member.member_6.member;
let _e663 = ((((_e652.member.member * _e620) + (_e652.member.member_1 * _e633)) + (_e652.member.member_2 * _e598)) + _e652.member_1);
let _e667 = global_1.member.member_6.member_1;
let _e678 = ((((_e667.member.member * _e620) + (_e667.member.member_1 * _e633)) + (_e667.member.member_2 * _e598)) + _e667.member_1);
let _e682 = global_1.member.member_6.member_2;
let _e693 = ((((_e682.member.member * _e620) + (_e682.member.member_1 * _e633)) + (_e682.member.member_2 * _e598)) + _e682.member_1);
let _e699 = ((((_e652.member.member * _e643) + (_e652.member.member_1 * _e648)) + (_e652.member.member_2 * _e637)) + _e652.member_1);
let _e705 = ((((_e667.member.member * _e643) + (_e667.member.member_1 * _e648)) + (_e667.member.member_2 * _e637)) + _e667.member_1);
let _e711 = ((((_e682.member.member * _e643) + (_e682.member.member_1 * _e648)) + (_e682.member.member_2 * _e637)) + _e682.member_1);
let _e713 = (_e100.member_2 == 2u);
let _e716 = (((_e100.member_2 == 1u) || _e713) || (_e100.member_2 == 5u));
if _e716 {
let _e721 = global_1.member.member_6.member_3.member;
let _e722 = (_e721 - 0.5f);
let _e724 = select(-0.5f, _e699, (_e699 > -0.5f));
let _e726 = select(_e722, _e724, (_e724 < _e722));
let _e731 = global_1.member.member_6.member_3.member_1;
let _e732 = (_e731 - 0.5f);
let _e734 = select(-0.5f, _e705, (_e705 > -0.5f));
let _e736 = select(_e732, _e734, (_e734 < _e732));
let _e741 = global_1.member.member_6.member_3.member_2;
let _e742 = (_e741 - 0.5f);
let _e744 = select(-0.5f, _e711, (_e711 > -0.5f));
let _e746 = select(_e742, _e744, (_e744 < _e742));
let _e748 = select(-1f, _e726, (_e726 > -1f));
let _e750 = select(_e721, _e748, (_e748 < _e721));
let _e757 = select(0i, select(select(i32(_e750), i32(-2147483648), (_e750 < -2147483600f)), 2147483647i, (_e750 > 2147483500f)), (_e750 == _e750));
let _e761 = (_e757 - select(0i, 1i, (_e750 < f32(_e757))));
let _e763 = select(-1f, _e736, (_e736 > -1f));
let _e765 = select(_e731, _e763, (_e763 < _e731));
let _e772 = select(0i, select(select(i32(_e765), i32(-2147483648), (_e765 < -2147483600f)), 2147483647i, (_e765 > 2147483500f)), (_e765 == _e765));
let _e776 = (_e772 - select(0i, 1i, (_e765 < f32(_e772))));
let _e778 = select(-1f, _e746, (_e746 > -1f));
let _e780 = select(_e741, _e778, (_e778 < _e741));
let _e787 = select(0i, select(select(i32(_e780), i32(-2147483648), (_e780 < -2147483600f)), 2147483647i, (_e780 > 2147483500f)), (_e780 == _e780));
let _e791 = (_e787 - select(0i, 1i, (_e780 < f32(_e787))));
let _e795 = global_1.member.member_6.member_7;
let _e799 = global_1.member.member_6.member_8;
let _e807 = (select(0i, select(select(i32(_e731), i32(-2147483648), (_e731 < -2147483600f)), 2147483647i, (_e731 > 2147483500f)), (_e731 == _e731)) - 1i);
let _e808 = (_e776 - 1i);
let _e813 = (_e776 + 1i);
let _e816 = (_e776 + 2i);
let _e826 = (select(0i, select(select(i32(_e741), i32(-2147483648), (_e741 < -2147483600f)), 2147483647i, (_e741 > 2147483500f)), (_e741 == _e741)) - 1i);
let _e827 = (_e791 - 1i);
let _e832 = (_e791 + 1i);
let _e835 = (_e791 + 2i);
let _e845 = (select(0i, select(select(i32(_e721), i32(-2147483648), (_e721 < -2147483600f)), 2147483647i, (_e721 > 2147483500f)), (_e721 == _e721)) - 1i);
let _e846 = (_e761 - 1i);
let _e851 = (_e761 + 1i);
let _e854 = (_e761 + 2i);
let _e857 = (select(0i, _e808, (_e808 > 0i)) * _e795);
let _e858 = (select(0i, _e776, (_e776 > 0i)) * _e795);
let _e859 = (select(_e807, _e813, (_e813 < _e807)) * _e795);
let _e860 = (select(_e807, _e816, (_e816 < _e807)) * _e795);
let _e861 = (select(0i, _e827, (_e827 > 0i)) * _e799);
let _e862 = (select(0i, _e791, (_e791 > 0i)) * _e799);
let _e863 = (select(_e826, _e832, (_e832 < _e826)) * _e799);
let _e864 = (select(_e826, _e835, (_e835 < _e826)) * _e799);
local_4 = type_28(array<i32, 4>(select(0i, _e846, (_e846 > 0i)), select(0i, _e761, (_e761 > 0i)), select(_e845, _e851, (_e851 < _e845)), select(_e845, _e854, (_e854 < _e845))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_5 = vec3<f32>((_e726 - f32(_e761)), (_e736 - f32(_e776)), (_e746 - f32(_e791)));
let _e875 = (_e862 + _e858);
let _e878 = local_4.member[0u];
let _e879 = (_e875 + _e878);
let _e881 = (bitcast<i32>(_e86) - 1i);
let _e883 = select(_e881, _e879, (_e879 < _e881));
let _e888 = global_2.member[bitcast<u32>(select(0i, _e883, (_e883 > 0i)))];
let _e889 = bitcast<f32>(_e888);
let _e892 = local_4.member[1u];
let _e893 = (_e875 + _e892);
let _e895 = select(_e881, _e893, (_e893 < _e881));
let _e900 = global_2.member[bitcast<u32>(select(0i, _e895, (_e895 > 0i)))];
let _e901 = bitcast<f32>(_e900);
let _e904 = local_4.member[2u];
let _e905 = (_e875 + _e904);
let _e907 = select(_e881, _e905, (_e905 < _e881));
let _e912 = global_2.member[bitcast<u32>(select(0i, _e907, (_e907 > 0i)))];
let _e913 = bitcast<f32>(_e912);
let _e916 = local_4.member[3u];
let _e917 = (_e875 + _e916);
let _e919 = select(_e881, _e917, (_e917 < _e881));
let _e924 = global_2.member[bitcast<u32>(select(0i, _e919, (_e919 > 0i)))];
let _e926 = local_5[0u];
let _e929 = (_e889 + ((_e901 - _e889) * _e926));
let _e930 = local_5[0u];
let _e933 = (_e901 + ((_e913 - _e901) * _e930));
let _e934 = local_5[0u];
let _e937 = (_e913 + ((bitcast<f32>(_e924) - _e913) * _e934));
let _e938 = (_e862 + _e859);
let _e939 = local_4.member[0u];
let _e940 = (_e938 + _e939);
let _e942 = select(_e881, _e940, (_e940 < _e881));
let _e947 = global_2.member[bitcast<u32>(select(0i, _e942, (_e942 > 0i)))];
let _e948 = bitcast<f32>(_e947);
let _e949 = local_4.member[1u];
let _e950 = (_e938 + _e949);
let _e952 = select(_e881, _e950, (_e950 < _e881));
let _e957 = global_2.member[bitcast<u32>(select(0i, _e952, (_e952 > 0i)))];
let _e958 = bitcast<f32>(_e957);
let _e959 = local_4.member[2u];
let _e960 = (_e938 + _e959);
let _e962 = select(_e881, _e960, (_e960 < _e881));
let _e967 = global_2.member[bitcast<u32>(select(0i, _e962, (_e962 > 0i)))];
let _e968 = bitcast<f32>(_e967);
let _e969 = local_4.member[3u];
let _e970 = (_e938 + _e969);
let _e972 = select(_e881, _e970, (_e970 < _e881));
let _e977 = global_2.member[bitcast<u32>(select(0i, _e972, (_e972 > 0i)))];
let _e979 = local_5[0u];
let _e983 = local_5[0u];
let _e986 = (_e958 + ((_e968 - _e958) * _e983));
let _e987 = local_5[0u];
let _e991 = (_e863 + _e858);
let _e992 = local_4.member[0u];
let _e993 = (_e991 + _e992);
let _e995 = select(_e881, _e993, (_e993 < _e881));
let _e1000 = global_2.member[bitcast<u32>(select(0i, _e995, (_e995 > 0i)))];
let _e1001 = bitcast<f32>(_e1000);
let _e1002 = local_4.member[1u];
let _e1003 = (_e991 + _e1002);
let _e1005 = select(_e881, _e1003, (_e1003 < _e881));
let _e1010 = global_2.member[bitcast<u32>(select(0i, _e1005, (_e1005 > 0i)))];
let _e1011 = bitcast<f32>(_e1010);
let _e1012 = local_4.member[2u];
let _e1013 = (_e991 + _e1012);
let _e1015 = select(_e881, _e1013, (_e1013 < _e881));
let _e1020 = global_2.member[bitcast<u32>(select(0i, _e1015, (_e1015 > 0i)))];
let _e1021 = bitcast<f32>(_e1020);
let _e1022 = local_4.member[3u];
let _e1023 = (_e991 + _e1022);
let _e1025 = select(_e881, _e1023, (_e1023 < _e881));
let _e1030 = global_2.member[bitcast<u32>(select(0i, _e1025, (_e1025 > 0i)))];
let _e1032 = local_5[0u];
let _e1035 = (_e1001 + ((_e1011 - _e1001) * _e1032));
let _e1036 = local_5[0u];
let _e1039 = (_e1011 + ((_e1021 - _e1011) * _e1036));
let _e1040 = local_5[0u];
let _e1043 = (_e1021 + ((bitcast<f32>(_e1030) - _e1021) * _e1040));
let _e1044 = (_e863 + _e859);
let _e1045 = local_4.member[0u];
let _e1046 = (_e1044 + _e1045);
let _e1048 = select(_e881, _e1046, (_e1046 < _e881));
let _e1053 = global_2.member[bitcast<u32>(select(0i, _e1048, (_e1048 > 0i)))];
let _e1054 = bitcast<f32>(_e1053);
let _e1055 = local_4.member[1u];
let _e1056 = (_e1044 + _e1055);
let _e1058 = select(_e881, _e1056, (_e1056 < _e881));
let _e1063 = global_2.member[bitcast<u32>(select(0i, _e1058, (_e1058 > 0i)))];
let _e1064 = bitcast<f32>(_e1063);
let _e1065 = local_4.member[2u];
let _e1066 = (_e1044 + _e1065);
let _e1068 = select(_e881, _e1066, (_e1066 < _e881));
let _e1073 = global_2.member[bitcast<u32>(select(0i, _e1068, (_e1068 > 0i)))];
let _e1074 = bitcast<f32>(_e1073);
let _e1075 = local_4.member[3u];
let _e1076 = (_e1044 + _e1075);
let _e1078 = select(_e881, _e1076, (_e1076 < _e881));
let _e1083 = global_2.member[bitcast<u32>(select(0i, _e1078, (_e1078 > 0i)))];
let _e1085 = local_5[0u];
let _e1089 = local_5[0u];
let _e1092 = (_e1064 + ((_e1074 - _e1064) * _e1089));
let _e1093 = local_5[0u];
let _e1097 = (_e862 + _e857);
let _e1098 = local_4.member[1u];
let _e1099 = (_e1097 + _e1098);
let _e1101 = select(_e881, _e1099, (_e1099 < _e881));
let _e1106 = global_2.member[bitcast<u32>(select(0i, _e1101, (_e1101 > 0i)))];
let _e1107 = bitcast<f32>(_e1106);
let _e1108 = local_4.member[2u];
let _e1109 = (_e1097 + _e1108);
let _e1111 = select(_e881, _e1109, (_e1109 < _e881));
let _e1116 = global_2.member[bitcast<u32>(select(0i, _e1111, (_e1111 > 0i)))];
let _e1118 = local_5[0u];
let _e1121 = (_e1107 + ((bitcast<f32>(_e1116) - _e1107) * _e1118));
let _e1122 = (_e862 + _e860);
let _e1123 = local_4.member[1u];
let _e1124 = (_e1122 + _e1123);
let _e1126 = select(_e881, _e1124, (_e1124 < _e881));
let _e1131 = global_2.member[bitcast<u32>(select(0i, _e1126, (_e1126 > 0i)))];
let _e1132 = bitcast<f32>(_e1131);
let _e1133 = local_4.member[2u];
let _e1134 = (_e1122 + _e1133);
let _e1136 = select(_e881, _e1134, (_e1134 < _e881));
let _e1141 = global_2.member[bitcast<u32>(select(0i, _e1136, (_e1136 > 0i)))];
let _e1143 = local_5[0u];
let _e1147 = (_e863 + _e857);
let _e1148 = local_4.member[1u];
let _e1149 = (_e1147 + _e1148);
let _e1151 = select(_e881, _e1149, (_e1149 < _e881));
let _e1156 = global_2.member[bitcast<u32>(select(0i, _e1151, (_e1151 > 0i)))];
let _e1157 = bitcast<f32>(_e1156);
let _e1158 = local_4.member[2u];
let _e1159 = (_e1147 + _e1158);
let _e1161 = select(_e881, _e1159, (_e1159 < _e881));
let _e1166 = global_2.member[bitcast<u32>(select(0i, _e1161, (_e1161 > 0i)))];
let _e1168 = local_5[0u];
let _e1171 = (_e1157 + ((bitcast<f32>(_e1166) - _e1157) * _e1168));
let _e1172 = (_e863 + _e860);
let _e1173 = local_4.member[1u];
let _e1174 = (_e1172 + _e1173);
let _e1176 = select(_e881, _e1174, (_e1174 < _e881));
let _e1181 = global_2.member[bitcast<u32>(select(0i, _e1176, (_e1176 > 0i)))];
let _e1182 = bitcast<f32>(_e1181);
let _e1183 = local_4.member[2u];
let _e1184 = (_e1172 + _e1183);
let _e1186 = select(_e881, _e1184, (_e1184 < _e881));
let _e1191 = global_2.member[bitcast<u32>(select(0i, _e1186, (_e1186 > 0i)))];
let _e1193 = local_5[0u];
let _e1197 = (_e861 + _e858);
let _e1198 = local_4.member[1u];
let _e1199 = (_e1197 + _e1198);
let _e1201 = select(_e881, _e1199, (_e1199 < _e881));
let _e1206 = global_2.member[bitcast<u32>(select(0i, _e1201, (_e1201 > 0i)))];
let _e1207 = bitcast<f32>(_e1206);
let _e1208 = local_4.member[2u];
let _e1209 = (_e1197 + _e1208);
let _e1211 = select(_e881, _e1209, (_e1209 < _e881));
let _e1216 = global_2.member[bitcast<u32>(select(0i, _e1211, (_e1211 > 0i)))];
let _e1218 = local_5[0u];
let _e1221 = (_e1207 + ((bitcast<f32>(_e1216) - _e1207) * _e1218));
let _e1222 = (_e864 + _e858);
let _e1223 = local_4.member[1u];
let _e1224 = (_e1222 + _e1223);
let _e1226 = select(_e881, _e1224, (_e1224 < _e881));
let _e1231 = global_2.member[bitcast<u32>(select(0i, _e1226, (_e1226 > 0i)))];
let _e1232 = bitcast<f32>(_e1231);
let _e1233 = local_4.member[2u];
let _e1234 = (_e1222 + _e1233);
let _e1236 = select(_e881, _e1234, (_e1234 < _e881));
let _e1241 = global_2.member[bitcast<u32>(select(0i, _e1236, (_e1236 > 0i)))];
let _e1243 = local_5[0u];
let _e1246 = (_e1232 + ((bitcast<f32>(_e1241) - _e1232) * _e1243));
let _e1247 = (_e861 + _e859);
let _e1248 = local_4.member[1u];
let _e1249 = (_e1247 + _e1248);
let _e1251 = select(_e881, _e1249, (_e1249 < _e881));
let _e1256 = global_2.member[bitcast<u32>(select(0i, _e1251, (_e1251 > 0i)))];
let _e1257 = bitcast<f32>(_e1256);
let _e1258 = local_4.member[2u];
let _e1259 = (_e1247 + _e1258);
let _e1261 = select(_e881, _e1259, (_e1259 < _e881));
let _e1266 = global_2.member[bitcast<u32>(select(0i, _e1261, (_e1261 > 0i)))];
let _e1268 = local_5[0u];
let _e1272 = (_e864 + _e859);
let _e1273 = local_4.member[1u];
let _e1274 = (_e1272 + _e1273);
let _e1276 = select(_e881, _e1274, (_e1274 < _e881));
let _e1281 = global_2.member[bitcast<u32>(select(0i, _e1276, (_e1276 > 0i)))];
let _e1282 = bitcast<f32>(_e1281);
let _e1283 = local_4.member[2u];
let _e1284 = (_e1272 + _e1283);
let _e1286 = select(_e881, _e1284, (_e1284 < _e881));
let _e1291 = global_2.member[bitcast<u32>(select(0i, _e1286, (_e1286 > 0i)))];
let _e1293 = local_5[0u];
let _e1298 = local_5[1u];
let _e1301 = (_e933 + ((_e986 - _e933) * _e1298));
let _e1302 = local_5[1u];
let _e1305 = (_e1039 + ((_e1092 - _e1039) * _e1302));
let _e1306 = local_5[1u];
let _e1309 = (_e929 + (((_e948 + ((_e958 - _e948) * _e979)) - _e929) * _e1306));
let _e1310 = local_5[1u];
let _e1315 = local_5[2u];
let _e1319 = local_5[1u];
let _e1322 = (_e937 + (((_e968 + ((bitcast<f32>(_e977) - _e968) * _e987)) - _e937) * _e1319));
let _e1323 = local_5[1u];
let _e1327 = local_5[2u];
let _e1331 = local_5[1u];
let _e1334 = (_e1121 + ((_e933 - _e1121) * _e1331));
let _e1335 = local_5[1u];
let _e1339 = local_5[2u];
let _e1343 = local_5[1u];
let _e1346 = (_e986 + (((_e1132 + ((bitcast<f32>(_e1141) - _e1132) * _e1143)) - _e986) * _e1343));
let _e1347 = local_5[1u];
let _e1351 = local_5[2u];
let _e1355 = local_5[1u];
let _e1358 = (_e1221 + (((_e1257 + ((bitcast<f32>(_e1266) - _e1257) * _e1268)) - _e1221) * _e1355));
let _e1359 = local_5[2u];
let _e1363 = local_5[1u];
let _e1367 = local_5[2u];
let _e1371 = local_5[2u];
let _e1378 = global_1.member.member_6.member_5;
let _e1383 = global_1.member.member_6.member_6;
let _e1384 = (((_e1301 + ((_e1305 - _e1301) * _e1371)) * _e1378) + _e1383);
let _e1386 = select(0f, _e1384, (_e1384 > 0f));
let _e1388 = select(1f, _e1386, (_e1386 < 1f));
let _e1390 = (((_e1309 + (((_e1035 + (((_e1054 + ((_e1064 - _e1054) * _e1085)) - _e1035) * _e1310)) - _e1309) * _e1315)) * _e1378) + _e1383);
let _e1392 = select(0f, _e1390, (_e1390 > 0f));
let _e1394 = select(1f, _e1392, (_e1392 < 1f));
let _e1396 = (((_e1322 + (((_e1043 + (((_e1074 + ((bitcast<f32>(_e1083) - _e1074) * _e1093)) - _e1043) * _e1323)) - _e1322) * _e1327)) * _e1378) + _e1383);
let _e1398 = select(0f, _e1396, (_e1396 > 0f));
let _e1400 = select(1f, _e1398, (_e1398 < 1f));
let _e1402 = (((_e1334 + (((_e1171 + ((_e1039 - _e1171) * _e1335)) - _e1334) * _e1339)) * _e1378) + _e1383);
let _e1404 = select(0f, _e1402, (_e1402 > 0f));
let _e1406 = select(1f, _e1404, (_e1404 < 1f));
let _e1408 = (((_e1346 + (((_e1092 + (((_e1182 + ((bitcast<f32>(_e1191) - _e1182) * _e1193)) - _e1092) * _e1347)) - _e1346) * _e1351)) * _e1378) + _e1383);
let _e1410 = select(0f, _e1408, (_e1408 > 0f));
let _e1412 = select(1f, _e1410, (_e1410 < 1f));
let _e1414 = (((_e1358 + ((_e1301 - _e1358) * _e1359)) * _e1378) + _e1383);
let _e1416 = select(0f, _e1414, (_e1414 > 0f));
let _e1418 = select(1f, _e1416, (_e1416 < 1f));
let _e1420 = (((_e1305 + (((_e1246 + (((_e1282 + ((bitcast<f32>(_e1291) - _e1282) * _e1293)) - _e1246) * _e1363)) - _e1305) * _e1367)) * _e1378) + _e1383);
let _e1422 = select(0f, _e1420, (_e1420 > 0f));
let _e1424 = select(1f, _e1422, (_e1422 < 1f));
let _e1425 = (_e1388 * 1024f);
let _e1426 = (1024f - 1f);
let _e1428 = select(0f, _e1425, (_e1425 > 0f));
let _e1430 = select(_e1426, _e1428, (_e1428 < _e1426));
let _e1437 = select(0i, select(select(i32(_e1430), i32(-2147483648), (_e1430 < -2147483600f)), 2147483647i, (_e1430 > 2147483500f)), (_e1430 == _e1430));
let _e1441 = (_e1437 - select(0i, 1i, (_e1430 < f32(_e1437))));
let _e1442 = (262147i + _e1441);
let _e1444 = (bitcast<i32>(_e90) - 1i);
let _e1446 = select(_e1444, _e1442, (_e1442 < _e1444));
let _e1452 = global_4.member[bitcast<u32>(select(0i, _e1446, (_e1446 > 0i)))];
let _e1462 = select(_e1444, 262146i, (262146i < _e1444));
let _e1468 = global_4.member[bitcast<u32>(select(0i, _e1462, (_e1462 > 0i)))];
let _e1469 = bitcast<f32>(_e1468);
let _e1470 = (f32((bitcast<i32>((_e1452 & 4095u)) - 2048i)) * _e1469);
let _e1472 = select(_e1444, 262144i, (262144i < _e1444));
let _e1478 = global_4.member[bitcast<u32>(select(0i, _e1472, (_e1472 > 0i)))];
let _e1479 = bitcast<f32>(_e1478);
let _e1481 = select(_e1444, 262145i, (262145i < _e1444));
let _e1487 = global_4.member[bitcast<u32>(select(0i, _e1481, (_e1481 > 0i)))];
let _e1488 = bitcast<f32>(_e1487);
let _e1494 = ((_e1479 + (f32(bitcast<i32>((_e1452 >> bitcast<u32>(12u)))) * _e1488)) + (_e1470 * (_e1425 - f32(_e1441))));
let _e1495 = (_e1470 * 1024f);
if _e713 {
let _e1502 = ((0.5f * (_e1400 - _e1394)) * _e1495);
let _e1503 = ((0.5f * (_e1412 - _e1406)) * _e1495);
let _e1504 = ((0.5f * (_e1424 - _e1418)) * _e1495);
phi_3190_ = type_29(_e1494, vec3<f32>(_e1502, _e1503, _e1504), vec3<f32>((_e1502 * _e1494), (_e1503 * _e1494), (_e1504 * _e1494)));
} else {
let _e1511 = (_e1394 * 1024f);
let _e1513 = select(0f, _e1511, (_e1511 > 0f));
let _e1515 = select(_e1426, _e1513, (_e1513 < _e1426));
let _e1522 = select(0i, select(select(i32(_e1515), i32(-2147483648), (_e1515 < -2147483600f)), 2147483647i, (_e1515 > 2147483500f)), (_e1515 == _e1515));
let _e1526 = (_e1522 - select(0i, 1i, (_e1515 < f32(_e1522))));
let _e1527 = (262147i + _e1526);
let _e1529 = select(_e1444, _e1527, (_e1527 < _e1444));
let _e1535 = global_4.member[bitcast<u32>(select(0i, _e1529, (_e1529 > 0i)))];
let _e1550 = ((_e1479 + (f32(bitcast<i32>((_e1535 >> bitcast<u32>(12u)))) * _e1488)) + ((f32((bitcast<i32>((_e1535 & 4095u)) - 2048i)) * _e1469) * (_e1511 - f32(_e1526))));
let _e1551 = (_e1400 * 1024f);
let _e1553 = select(0f, _e1551, (_e1551 > 0f));
let _e1555 = select(_e1426, _e1553, (_e1553 < _e1426));
let _e1562 = select(0i, select(select(i32(_e1555), i32(-2147483648), (_e1555 < -2147483600f)), 2147483647i, (_e1555 > 2147483500f)), (_e1555 == _e1555));
let _e1566 = (_e1562 - select(0i, 1i, (_e1555 < f32(_e1562))));
let _e1567 = (262147i + _e1566);
let _e1569 = select(_e1444, _e1567, (_e1567 < _e1444));
let _e1575 = global_4.member[bitcast<u32>(select(0i, _e1569, (_e1569 > 0i)))];
let _e1590 = ((_e1479 + (f32(bitcast<i32>((_e1575 >> bitcast<u32>(12u)))) * _e1488)) + ((f32((bitcast<i32>((_e1575 & 4095u)) - 2048i)) * _e1469) * (_e1551 - f32(_e1566))));
let _e1591 = (_e1406 * 1024f);
let _e1593 = select(0f, _e1591, (_e1591 > 0f));
let _e1595 = select(_e1426, _e1593, (_e1593 < _e1426));
let _e1602 = select(0i, select(select(i32(_e1595), i32(-2147483648), (_e1595 < -2147483600f)), 2147483647i, (_e1595 > 2147483500f)), (_e1595 == _e1595));
let _e1606 = (_e1602 - select(0i, 1i, (_e1595 < f32(_e1602))));
let _e1607 = (262147i + _e1606);
let _e1609 = select(_e1444, _e1607, (_e1607 < _e1444));
let _e1615 = global_4.member[bitcast<u32>(select(0i, _e1609, (_e1609 > 0i)))];
let _e1630 = ((_e1479 + (f32(bitcast<i32>((_e1615 >> bitcast<u32>(12u)))) * _e1488)) + ((f32((bitcast<i32>((_e1615 & 4095u)) - 2048i)) * _e1469) * (_e1591 - f32(_e1606))));
let _e1631 = (_e1412 * 1024f);
let _e1633 = select(0f, _e1631, (_e1631 > 0f));
let _e1635 = select(_e1426, _e1633, (_e1633 < _e1426));
let _e1642 = select(0i, select(select(i32(_e1635), i32(-2147483648), (_e1635 < -2147483600f)), 2147483647i, (_e1635 > 2147483500f)), (_e1635 == _e1635));
let _e1646 = (_e1642 - select(0i, 1i, (_e1635 < f32(_e1642))));
let _e1647 = (262147i + _e1646);
let _e1649 = select(_e1444, _e1647, (_e1647 < _e1444));
let _e1655 = global_4.member[bitcast<u32>(select(0i, _e1649, (_e1649 > 0i)))];
let _e1670 = ((_e1479 + (f32(bitcast<i32>((_e1655 >> bitcast<u32>(12u)))) * _e1488)) + ((f32((bitcast<i32>((_e1655 & 4095u)) - 2048i)) * _e1469) * (_e1631 - f32(_e1646))));
let _e1671 = (_e1418 * 1024f);
let _e1673 = select(0f, _e1671, (_e1671 > 0f));
let _e1675 = select(_e1426, _e1673, (_e1673 < _e1426));
let _e1682 = select(0i, select(select(i32(_e1675), i32(-2147483648), (_e1675 < -2147483600f)), 2147483647i, (_e1675 > 2147483500f)), (_e1675 == _e1675));
let _e1686 = (_e1682 - select(0i, 1i, (_e1675 < f32(_e1682))));
let _e1687 = (262147i + _e1686);
let _e1689 = select(_e1444, _e1687, (_e1687 < _e1444));
let _e1695 = global_4.member[bitcast<u32>(select(0i, _e1689, (_e1689 > 0i)))];
let _e1710 = ((_e1479 + (f32(bitcast<i32>((_e1695 >> bitcast<u32>(12u)))) * _e1488)) + ((f32((bitcast<i32>((_e1695 & 4095u)) - 2048i)) * _e1469) * (_e1671 - f32(_e1686))));
let _e1711 = (_e1424 * 1024f);
let _e1713 = select(0f, _e1711, (_e1711 > 0f));
let _e1715 = select(_e1426, _e1713, (_e1713 < _e1426));
let _e1722 = select(0i, select(select(i32(_e1715), i32(-2147483648), (_e1715 < -2147483600f)), 2147483647i, (_e1715 > 2147483500f)), (_e1715 == _e1715));
let _e1726 = (_e1722 - select(0i, 1i, (_e1715 < f32(_e1722))));
let _e1727 = (262147i + _e1726);
let _e1729 = select(_e1444, _e1727, (_e1727 < _e1444));
let _e1735 = global_4.member[bitcast<u32>(select(0i, _e1729, (_e1729 > 0i)))];
let _e1750 = ((_e1479 + (f32(bitcast<i32>((_e1735 >> bitcast<u32>(12u)))) * _e1488)) + ((f32((bitcast<i32>((_e1735 & 4095u)) - 2048i)) * _e1469) * (_e1711 - f32(_e1726))));
let _e1751 = (_e1590 - _e1550);
let _e1753 = (_e1670 - _e1630);
let _e1755 = (_e1750 - _e1710);
phi_3190_ = type_29(_e1494, vec3<f32>((0.5f * _e1751), (0.5f * _e1753), (0.5f * _e1755)), vec3<f32>((0.25f * (_e1751 * (_e1590 + _e1550))), (0.25f * (_e1753 * (_e1670 + _e1630))), (0.25f * (_e1755 * (_e1750 + _e1710)))));
}
let _e1770 = phi_3190_;
let _e1785 = select(0f, 1f, ((((((_e699 >= -0.5f) && (_e699 <= _e722)) && (_e705 >= -0.5f)) && (_e705 <= _e732)) && (_e711 >= -0.5f)) && (_e711 <= _e742)));
let _e1787 = (0.5f * (_e1400 - _e1394));
let _e1789 = (0.5f * (_e1412 - _e1406));
let _e1791 = (0.5f * (_e1424 - _e1418));
let _e1797 = global_1.member.member_6.member.member.member;
let _e1803 = global_1.member.member_6.member.member.member_1;
let _e1809 = global_1.member.member_6.member.member.member_2;
let _e1815 = global_1.member.member_6.member_1.member.member;
let _e1821 = global_1.member.member_6.member_1.member.member_1;
let _e1827 = global_1.member.member_6.member_1.member.member_2;
let _e1833 = global_1.member.member_6.member_2.member.member;
let _e1839 = global_1.member.member_6.member_2.member.member_1;
let _e1845 = global_1.member.member_6.member_2.member.member_2;
phi_3836_ = type_30(_e1388, vec3<f32>(((((_e1797 * _e1787) + (_e1815 * _e1789)) + (_e1833 * _e1791)) * _e1785), ((((_e1803 * _e1787) + (_e1821 * _e1789)) + (_e1839 * _e1791)) * _e1785), ((((_e1809 * _e1787) + (_e1827 * _e1789)) + (_e1845 * _e1791)) * _e1785)), _e1770.member, vec3<f32>(((((_e1797 * _e1770.member_2.x) + (_e1815 * _e1770.member_2.y)) + (_e1833 * _e1770.member_2.z)) * _e1785), ((((_e1803 * _e1770.member_2.x) + (_e1821 * _e1770.member_2.y)) + (_e1839 * _e1770.member_2.z)) * _e1785), ((((_e1809 * _e1770.member_2.x) + (_e1827 * _e1770.member_2.y)) + (_e1845 * _e1770.member_2.z)) * _e1785)), vec3<f32>(((((_e1797 * _e1770.member_1.x) + (_e1815 * _e1770.member_1.y)) + (_e1833 * _e1770.member_1.z)) * _e1785), ((((_e1803 * _e1770.member_1.x) + (_e1821 * _e1770.member_1.y)) + (_e1839 * _e1770.member_1.z)) * _e1785), ((((_e1809 * _e1770.member_1.x) + (_e1827 * _e1770.member_1.y)) + (_e1845 * _e1770.member_1.z)) * _e1785)));
} else {
let _e1914 = global_1.member.member_6.member_3.member;
let _e1915 = (_e1914 - 0.5f);
let _e1917 = select(-0.5f, _e699, (_e699 > -0.5f));
let _e1919 = select(_e1915, _e1917, (_e1917 < _e1915));
let _e1924 = global_1.member.member_6.member_3.member_1;
let _e1925 = (_e1924 - 0.5f);
let _e1927 = select(-0.5f, _e705, (_e705 > -0.5f));
let _e1929 = select(_e1925, _e1927, (_e1927 < _e1925));
let _e1934 = global_1.member.member_6.member_3.member_2;
let _e1935 = (_e1934 - 0.5f);
let _e1937 = select(-0.5f, _e711, (_e711 > -0.5f));
let _e1939 = select(_e1935, _e1937, (_e1937 < _e1935));
let _e1941 = select(-1f, _e1919, (_e1919 > -1f));
let _e1943 = select(_e1914, _e1941, (_e1941 < _e1914));
let _e1950 = select(0i, select(select(i32(_e1943), i32(-2147483648), (_e1943 < -2147483600f)), 2147483647i, (_e1943 > 2147483500f)), (_e1943 == _e1943));
let _e1954 = (_e1950 - select(0i, 1i, (_e1943 < f32(_e1950))));
let _e1956 = select(-1f, _e1929, (_e1929 > -1f));
let _e1958 = select(_e1924, _e1956, (_e1956 < _e1924));
let _e1965 = select(0i, select(select(i32(_e1958), i32(-2147483648), (_e1958 < -2147483600f)), 2147483647i, (_e1958 > 2147483500f)), (_e1958 == _e1958));
let _e1969 = (_e1965 - select(0i, 1i, (_e1958 < f32(_e1965))));
let _e1971 = select(-1f, _e1939, (_e1939 > -1f));
let _e1973 = select(_e1934, _e1971, (_e1971 < _e1934));
let _e1980 = select(0i, select(select(i32(_e1973), i32(-2147483648), (_e1973 < -2147483600f)), 2147483647i, (_e1973 > 2147483500f)), (_e1973 == _e1973));
let _e1984 = (_e1980 - select(0i, 1i, (_e1973 < f32(_e1980))));
let _e1988 = global_1.member.member_6.member_7;
let _e1992 = global_1.member.member_6.member_8;
let _e2000 = (select(0i, select(select(i32(_e1924), i32(-2147483648), (_e1924 < -2147483600f)), 2147483647i, (_e1924 > 2147483500f)), (_e1924 == _e1924)) - 1i);
let _e2003 = (_e1969 + 1i);
let _e2013 = (select(0i, select(select(i32(_e1934), i32(-2147483648), (_e1934 < -2147483600f)), 2147483647i, (_e1934 > 2147483500f)), (_e1934 == _e1934)) - 1i);
let _e2016 = (_e1984 + 1i);
let _e2026 = (select(0i, select(select(i32(_e1914), i32(-2147483648), (_e1914 < -2147483600f)), 2147483647i, (_e1914 > 2147483500f)), (_e1914 == _e1914)) - 1i);
let _e2027 = (_e1954 - 1i);
let _e2032 = (_e1954 + 1i);
let _e2035 = (_e1954 + 2i);
let _e2038 = (select(0i, _e1969, (_e1969 > 0i)) * _e1988);
let _e2039 = (select(_e2000, _e2003, (_e2003 < _e2000)) * _e1988);
let _e2040 = (select(0i, _e1984, (_e1984 > 0i)) * _e1992);
let _e2041 = (select(_e2013, _e2016, (_e2016 < _e2013)) * _e1992);
local_2 = type_28(array<i32, 4>(select(0i, _e2027, (_e2027 > 0i)), select(0i, _e1954, (_e1954 > 0i)), select(_e2026, _e2032, (_e2032 < _e2026)), select(_e2026, _e2035, (_e2035 < _e2026))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_3 = vec3<f32>((_e1919 - f32(_e1954)), (_e1929 - f32(_e1969)), (_e1939 - f32(_e1984)));
let _e2052 = (_e2040 + _e2038);
let _e2055 = local_2.member[1u];
let _e2056 = (_e2052 + _e2055);
let _e2058 = (bitcast<i32>(_e86) - 1i);
let _e2060 = select(_e2058, _e2056, (_e2056 < _e2058));
let _e2065 = global_2.member[bitcast<u32>(select(0i, _e2060, (_e2060 > 0i)))];
let _e2066 = bitcast<f32>(_e2065);
let _e2069 = local_2.member[2u];
let _e2070 = (_e2052 + _e2069);
let _e2072 = select(_e2058, _e2070, (_e2070 < _e2058));
let _e2077 = global_2.member[bitcast<u32>(select(0i, _e2072, (_e2072 > 0i)))];
let _e2079 = local_3[0u];
let _e2082 = (_e2066 + ((bitcast<f32>(_e2077) - _e2066) * _e2079));
let _e2083 = (_e2040 + _e2039);
let _e2084 = local_2.member[1u];
let _e2085 = (_e2083 + _e2084);
let _e2087 = select(_e2058, _e2085, (_e2085 < _e2058));
let _e2092 = global_2.member[bitcast<u32>(select(0i, _e2087, (_e2087 > 0i)))];
let _e2093 = bitcast<f32>(_e2092);
let _e2094 = local_2.member[2u];
let _e2095 = (_e2083 + _e2094);
let _e2097 = select(_e2058, _e2095, (_e2095 < _e2058));
let _e2102 = global_2.member[bitcast<u32>(select(0i, _e2097, (_e2097 > 0i)))];
let _e2104 = local_3[0u];
let _e2109 = local_3[1u];
let _e2112 = (_e2082 + (((_e2093 + ((bitcast<f32>(_e2102) - _e2093) * _e2104)) - _e2082) * _e2109));
let _e2113 = (_e2041 + _e2038);
let _e2114 = local_2.member[1u];
let _e2115 = (_e2113 + _e2114);
let _e2117 = select(_e2058, _e2115, (_e2115 < _e2058));
let _e2122 = global_2.member[bitcast<u32>(select(0i, _e2117, (_e2117 > 0i)))];
let _e2123 = bitcast<f32>(_e2122);
let _e2124 = local_2.member[2u];
let _e2125 = (_e2113 + _e2124);
let _e2127 = select(_e2058, _e2125, (_e2125 < _e2058));
let _e2132 = global_2.member[bitcast<u32>(select(0i, _e2127, (_e2127 > 0i)))];
let _e2134 = local_3[0u];
let _e2137 = (_e2123 + ((bitcast<f32>(_e2132) - _e2123) * _e2134));
let _e2138 = (_e2041 + _e2039);
let _e2139 = local_2.member[1u];
let _e2140 = (_e2138 + _e2139);
let _e2142 = select(_e2058, _e2140, (_e2140 < _e2058));
let _e2147 = global_2.member[bitcast<u32>(select(0i, _e2142, (_e2142 > 0i)))];
let _e2148 = bitcast<f32>(_e2147);
let _e2149 = local_2.member[2u];
let _e2150 = (_e2138 + _e2149);
let _e2152 = select(_e2058, _e2150, (_e2150 < _e2058));
let _e2157 = global_2.member[bitcast<u32>(select(0i, _e2152, (_e2152 > 0i)))];
let _e2159 = local_3[0u];
let _e2163 = local_3[1u];
let _e2168 = local_3[2u];
let _e2175 = global_1.member.member_6.member_5;
let _e2180 = global_1.member.member_6.member_6;
let _e2181 = (((_e2112 + (((_e2137 + (((_e2148 + ((bitcast<f32>(_e2157) - _e2148) * _e2159)) - _e2137) * _e2163)) - _e2112) * _e2168)) * _e2175) + _e2180);
let _e2183 = select(0f, _e2181, (_e2181 > 0f));
phi_3836_ = type_30(select(1f, _e2183, (_e2183 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2188 = phi_3836_;
let _e2193 = global_1.member.member_6.member_3.member;
let _e2194 = (_e2193 - 0.5f);
let _e2196 = select(-0.5f, _e663, (_e663 > -0.5f));
let _e2198 = select(_e2194, _e2196, (_e2196 < _e2194));
let _e2203 = global_1.member.member_6.member_3.member_1;
let _e2204 = (_e2203 - 0.5f);
let _e2206 = select(-0.5f, _e678, (_e678 > -0.5f));
let _e2208 = select(_e2204, _e2206, (_e2206 < _e2204));
let _e2213 = global_1.member.member_6.member_3.member_2;
let _e2214 = (_e2213 - 0.5f);
let _e2216 = select(-0.5f, _e693, (_e693 > -0.5f));
let _e2218 = select(_e2214, _e2216, (_e2216 < _e2214));
let _e2220 = select(-1f, _e2198, (_e2198 > -1f));
let _e2222 = select(_e2193, _e2220, (_e2220 < _e2193));
let _e2229 = select(0i, select(select(i32(_e2222), i32(-2147483648), (_e2222 < -2147483600f)), 2147483647i, (_e2222 > 2147483500f)), (_e2222 == _e2222));
let _e2233 = (_e2229 - select(0i, 1i, (_e2222 < f32(_e2229))));
let _e2235 = select(-1f, _e2208, (_e2208 > -1f));
let _e2237 = select(_e2203, _e2235, (_e2235 < _e2203));
let _e2244 = select(0i, select(select(i32(_e2237), i32(-2147483648), (_e2237 < -2147483600f)), 2147483647i, (_e2237 > 2147483500f)), (_e2237 == _e2237));
let _e2248 = (_e2244 - select(0i, 1i, (_e2237 < f32(_e2244))));
let _e2250 = select(-1f, _e2218, (_e2218 > -1f));
let _e2252 = select(_e2213, _e2250, (_e2250 < _e2213));
let _e2259 = select(0i, select(select(i32(_e2252), i32(-2147483648), (_e2252 < -2147483600f)), 2147483647i, (_e2252 > 2147483500f)), (_e2252 == _e2252));
let _e2263 = (_e2259 - select(0i, 1i, (_e2252 < f32(_e2259))));
let _e2267 = global_1.member.member_6.member_7;
let _e2271 = global_1.member.member_6.member_8;
let _e2279 = (select(0i, select(select(i32(_e2203), i32(-2147483648), (_e2203 < -2147483600f)), 2147483647i, (_e2203 > 2147483500f)), (_e2203 == _e2203)) - 1i);
let _e2282 = (_e2248 + 1i);
let _e2292 = (select(0i, select(select(i32(_e2213), i32(-2147483648), (_e2213 < -2147483600f)), 2147483647i, (_e2213 > 2147483500f)), (_e2213 == _e2213)) - 1i);
let _e2295 = (_e2263 + 1i);
let _e2305 = (select(0i, select(select(i32(_e2193), i32(-2147483648), (_e2193 < -2147483600f)), 2147483647i, (_e2193 > 2147483500f)), (_e2193 == _e2193)) - 1i);
let _e2306 = (_e2233 - 1i);
let _e2311 = (_e2233 + 1i);
let _e2314 = (_e2233 + 2i);
let _e2317 = (select(0i, _e2248, (_e2248 > 0i)) * _e2267);
let _e2318 = (select(_e2279, _e2282, (_e2282 < _e2279)) * _e2267);
let _e2319 = (select(0i, _e2263, (_e2263 > 0i)) * _e2271);
let _e2320 = (select(_e2292, _e2295, (_e2295 < _e2292)) * _e2271);
local = type_28(array<i32, 4>(select(0i, _e2306, (_e2306 > 0i)), select(0i, _e2233, (_e2233 > 0i)), select(_e2305, _e2311, (_e2311 < _e2305)), select(_e2305, _e2314, (_e2314 < _e2305))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_1 = vec3<f32>((_e2198 - f32(_e2233)), (_e2208 - f32(_e2248)), (_e2218 - f32(_e2263)));
let _e2331 = (_e2319 + _e2317);
let _e2334 = local.member[1u];
let _e2335 = (_e2331 + _e2334);
let _e2337 = (bitcast<i32>(_e86) - 1i);
let _e2339 = select(_e2337, _e2335, (_e2335 < _e2337));
let _e2344 = global_2.member[bitcast<u32>(select(0i, _e2339, (_e2339 > 0i)))];
let _e2345 = bitcast<f32>(_e2344);
let _e2348 = local.member[2u];
let _e2349 = (_e2331 + _e2348);
let _e2351 = select(_e2337, _e2349, (_e2349 < _e2337));
let _e2356 = global_2.member[bitcast<u32>(select(0i, _e2351, (_e2351 > 0i)))];
let _e2358 = local_1[0u];
let _e2361 = (_e2345 + ((bitcast<f32>(_e2356) - _e2345) * _e2358));
let _e2362 = (_e2319 + _e2318);
let _e2363 = local.member[1u];
let _e2364 = (_e2362 + _e2363);
let _e2366 = select(_e2337, _e2364, (_e2364 < _e2337));
let _e2371 = global_2.member[bitcast<u32>(select(0i, _e2366, (_e2366 > 0i)))];
let _e2372 = bitcast<f32>(_e2371);
let _e2373 = local.member[2u];
let _e2374 = (_e2362 + _e2373);
let _e2376 = select(_e2337, _e2374, (_e2374 < _e2337));
let _e2381 = global_2.member[bitcast<u32>(select(0i, _e2376, (_e2376 > 0i)))];
let _e2383 = local_1[0u];
let _e2388 = local_1[1u];
let _e2391 = (_e2361 + (((_e2372 + ((bitcast<f32>(_e2381) - _e2372) * _e2383)) - _e2361) * _e2388));
let _e2392 = (_e2320 + _e2317);
let _e2393 = local.member[1u];
let _e2394 = (_e2392 + _e2393);
let _e2396 = select(_e2337, _e2394, (_e2394 < _e2337));
let _e2401 = global_2.member[bitcast<u32>(select(0i, _e2396, (_e2396 > 0i)))];
let _e2402 = bitcast<f32>(_e2401);
let _e2403 = local.member[2u];
let _e2404 = (_e2392 + _e2403);
let _e2406 = select(_e2337, _e2404, (_e2404 < _e2337));
let _e2411 = global_2.member[bitcast<u32>(select(0i, _e2406, (_e2406 > 0i)))];
let _e2413 = local_1[0u];
let _e2416 = (_e2402 + ((bitcast<f32>(_e2411) - _e2402) * _e2413));
let _e2417 = (_e2320 + _e2318);
let _e2418 = local.member[1u];
let _e2419 = (_e2417 + _e2418);
let _e2421 = select(_e2337, _e2419, (_e2419 < _e2337));
let _e2426 = global_2.member[bitcast<u32>(select(0i, _e2421, (_e2421 > 0i)))];
let _e2427 = bitcast<f32>(_e2426);
let _e2428 = local.member[2u];
let _e2429 = (_e2417 + _e2428);
let _e2431 = select(_e2337, _e2429, (_e2429 < _e2337));
let _e2436 = global_2.member[bitcast<u32>(select(0i, _e2431, (_e2431 > 0i)))];
let _e2438 = local_1[0u];
let _e2442 = local_1[1u];
let _e2447 = local_1[2u];
let _e2454 = global_1.member.member_6.member_5;
let _e2459 = global_1.member.member_6.member_6;
let _e2460 = (((_e2391 + (((_e2416 + (((_e2427 + ((bitcast<f32>(_e2436) - _e2427) * _e2438)) - _e2416) * _e2442)) - _e2391) * _e2447)) * _e2454) + _e2459);
let _e2462 = select(0f, _e2460, (_e2460 > 0f));
let _e2464 = select(1f, _e2462, (_e2462 < 1f));
let _e2467 = global_1.member.member_1;
if ((_e2467 & 16u) == 0u) {
phi_4669_ = type_5(1f, 1f, 1f);
} else {
let _e2473 = global_1.member.member_14.member;
let _e2484 = ((((_e2473.member.member * _e620) + (_e2473.member.member_1 * _e633)) + (_e2473.member.member_2 * _e598)) + _e2473.member_1);
let _e2490 = ((((_e2473.member.member * _e643) + (_e2473.member.member_1 * _e648)) + (_e2473.member.member_2 * _e637)) + _e2473.member_1);
let _e2492 = select(_e2490, _e2484, (_e2484 < _e2490));
let _e2494 = select(_e2490, _e2484, (_e2484 > _e2490));
let _e2496 = (_e2494 - _e2492);
let _e2499 = (-(_e2492) / select(1e-30f, _e2496, (_e2496 > 1e-30f)));
let _e2501 = select(0f, _e2499, (_e2499 > 0f));
let _e2507 = select(select(select(1f, _e2501, (_e2501 < 1f)), 1f, (_e2494 <= 0f)), 0f, (_e2492 > 0f));
let _e2512 = global_1.member.member_14.member_1;
let _e2513 = (_e2512 != 0u);
let _e2523 = global_1.member.member_15.member;
let _e2534 = ((((_e2523.member.member * _e620) + (_e2523.member.member_1 * _e633)) + (_e2523.member.member_2 * _e598)) + _e2523.member_1);
let _e2540 = ((((_e2523.member.member * _e643) + (_e2523.member.member_1 * _e648)) + (_e2523.member.member_2 * _e637)) + _e2523.member_1);
let _e2542 = select(_e2540, _e2534, (_e2534 < _e2540));
let _e2544 = select(_e2540, _e2534, (_e2534 > _e2540));
let _e2546 = (_e2544 - _e2542);
let _e2549 = (-(_e2542) / select(1e-30f, _e2546, (_e2546 > 1e-30f)));
let _e2551 = select(0f, _e2549, (_e2549 > 0f));
let _e2557 = select(select(select(1f, _e2551, (_e2551 < 1f)), 1f, (_e2544 <= 0f)), 0f, (_e2542 > 0f));
let _e2562 = global_1.member.member_15.member_1;
let _e2563 = (_e2562 != 0u);
let _e2573 = global_1.member.member_16.member;
let _e2584 = ((((_e2573.member.member * _e620) + (_e2573.member.member_1 * _e633)) + (_e2573.member.member_2 * _e598)) + _e2573.member_1);
let _e2590 = ((((_e2573.member.member * _e643) + (_e2573.member.member_1 * _e648)) + (_e2573.member.member_2 * _e637)) + _e2573.member_1);
let _e2592 = select(_e2590, _e2584, (_e2584 < _e2590));
let _e2594 = select(_e2590, _e2584, (_e2584 > _e2590));
let _e2596 = (_e2594 - _e2592);
let _e2599 = (-(_e2592) / select(1e-30f, _e2596, (_e2596 > 1e-30f)));
let _e2601 = select(0f, _e2599, (_e2599 > 0f));
let _e2607 = select(select(select(1f, _e2601, (_e2601 < 1f)), 1f, (_e2594 <= 0f)), 0f, (_e2592 > 0f));
let _e2612 = global_1.member.member_16.member_1;
let _e2613 = (_e2612 != 0u);
let _e2623 = global_1.member.member_17.member;
let _e2634 = ((((_e2623.member.member * _e620) + (_e2623.member.member_1 * _e633)) + (_e2623.member.member_2 * _e598)) + _e2623.member_1);
let _e2640 = ((((_e2623.member.member * _e643) + (_e2623.member.member_1 * _e648)) + (_e2623.member.member_2 * _e637)) + _e2623.member_1);
let _e2642 = select(_e2640, _e2634, (_e2634 < _e2640));
let _e2644 = select(_e2640, _e2634, (_e2634 > _e2640));
let _e2646 = (_e2644 - _e2642);
let _e2649 = (-(_e2642) / select(1e-30f, _e2646, (_e2646 > 1e-30f)));
let _e2651 = select(0f, _e2649, (_e2649 > 0f));
let _e2657 = select(select(select(1f, _e2651, (_e2651 < 1f)), 1f, (_e2644 <= 0f)), 0f, (_e2642 > 0f));
let _e2662 = global_1.member.member_17.member_1;
let _e2663 = (_e2662 != 0u);
phi_4669_ = type_5(((((1f * _e2507) * _e2557) * _e2607) * _e2657), ((((1f * select(1f, _e2507, _e2513)) * select(1f, _e2557, _e2563)) * select(1f, _e2607, _e2613)) * select(1f, _e2657, _e2663)), ((((1f * select(1f, 0f, (_e2513 && (_e2490 > 0f)))) * select(1f, 0f, (_e2563 && (_e2540 > 0f)))) * select(1f, 0f, (_e2613 && (_e2590 > 0f)))) * select(1f, 0f, (_e2663 && (_e2640 > 0f)))));
}
let _e2672 = phi_4669_;
let _e2673 = (_e699 - _e663);
let _e2677 = (bitcast<f32>((bitcast<u32>(_e2673) & 2147483647u)) < 1e-12f);
let _e2679 = (1f / select(_e2673, 1f, _e2677));
let _e2681 = ((-0.5f - _e663) * _e2679);
let _e2683 = ((_e2194 - _e663) * _e2679);
let _e2689 = select(_e2683, _e2681, (_e2681 < _e2683));
let _e2691 = select(0f, _e2689, (_e2689 > 0f));
let _e2694 = select(select(1f, _e2691, (_e2691 < 1f)), select(2f, 0f, ((_e663 >= -0.5f) && (_e663 <= _e2194))), _e2677);
let _e2696 = select(_e2683, _e2681, (_e2681 > _e2683));
let _e2698 = select(0f, _e2696, (_e2696 > 0f));
let _e2701 = select(select(1f, _e2698, (_e2698 < 1f)), 1f, _e2677);
let _e2702 = (_e705 - _e678);
let _e2706 = (bitcast<f32>((bitcast<u32>(_e2702) & 2147483647u)) < 1e-12f);
let _e2708 = (1f / select(_e2702, 1f, _e2706));
let _e2710 = ((-0.5f - _e678) * _e2708);
let _e2712 = ((_e2204 - _e678) * _e2708);
let _e2718 = select(_e2712, _e2710, (_e2710 < _e2712));
let _e2720 = select(0f, _e2718, (_e2718 > 0f));
let _e2723 = select(select(1f, _e2720, (_e2720 < 1f)), select(2f, 0f, ((_e678 >= -0.5f) && (_e678 <= _e2204))), _e2706);
let _e2725 = select(_e2712, _e2710, (_e2710 > _e2712));
let _e2727 = select(0f, _e2725, (_e2725 > 0f));
let _e2730 = select(select(1f, _e2727, (_e2727 < 1f)), 1f, _e2706);
let _e2731 = (_e711 - _e693);
let _e2735 = (bitcast<f32>((bitcast<u32>(_e2731) & 2147483647u)) < 1e-12f);
let _e2737 = (1f / select(_e2731, 1f, _e2735));
let _e2739 = ((-0.5f - _e693) * _e2737);
let _e2741 = ((_e2214 - _e693) * _e2737);
let _e2747 = select(_e2741, _e2739, (_e2739 < _e2741));
let _e2749 = select(0f, _e2747, (_e2747 > 0f));
let _e2752 = select(select(1f, _e2749, (_e2749 < 1f)), select(2f, 0f, ((_e693 >= -0.5f) && (_e693 <= _e2214))), _e2735);
let _e2754 = select(_e2741, _e2739, (_e2739 > _e2741));
let _e2756 = select(0f, _e2754, (_e2754 > 0f));
let _e2759 = select(select(1f, _e2756, (_e2756 < 1f)), 1f, _e2735);
let _e2761 = select(_e2730, _e2701, (_e2701 < _e2730));
let _e2765 = select(_e2723, _e2694, (_e2694 > _e2723));
let _e2768 = (select(_e2759, _e2761, (_e2761 < _e2759)) - select(_e2752, _e2765, (_e2765 > _e2752)));
let _e2771 = (_e643 - _e620);
let _e2772 = (_e648 - _e633);
let _e2773 = (_e637 - _e598);
let _e2778 = (((_e2771 * _e2771) + (_e2772 * _e2772)) + (_e2773 * _e2773));
let _e2786 = global_1.member.member_5.member_3;
let _e2787 = ((sqrt(select(0f, _e2778, (_e2778 > 0f))) * select(0f, _e2768, (_e2768 > 0f))) * _e2786);
if (_e100.member_2 >= 3u) {
let _e2790 = (_e2464 * 255f);
let _e2791 = (_e2188.member * 255f);
let _e2792 = (255f - 1f);
let _e2794 = select(0f, _e2790, (_e2790 > 0f));
let _e2796 = select(_e2792, _e2794, (_e2794 < _e2792));
let _e2803 = select(0i, select(select(i32(_e2796), i32(-2147483648), (_e2796 < -2147483600f)), 2147483647i, (_e2796 > 2147483500f)), (_e2796 == _e2796));
let _e2807 = (_e2803 - select(0i, 1i, (_e2796 < f32(_e2803))));
let _e2809 = select(0f, _e2791, (_e2791 > 0f));
let _e2811 = select(_e2792, _e2809, (_e2809 < _e2792));
let _e2818 = select(0i, select(select(i32(_e2811), i32(-2147483648), (_e2811 < -2147483600f)), 2147483647i, (_e2811 > 2147483500f)), (_e2811 == _e2811));
let _e2822 = (_e2818 - select(0i, 1i, (_e2811 < f32(_e2818))));
let _e2825 = (((_e2807 * 256i) + _e2822) * 4i);
let _e2829 = (_e2791 - f32(_e2822));
let _e2831 = (bitcast<i32>(_e90) - 1i);
let _e2833 = select(_e2831, _e2825, (_e2825 < _e2831));
let _e2839 = global_4.member[bitcast<u32>(select(0i, _e2833, (_e2833 > 0i)))];
let _e2840 = (_e2825 + 4i);
let _e2842 = select(_e2831, _e2840, (_e2840 < _e2831));
let _e2848 = global_4.member[bitcast<u32>(select(0i, _e2842, (_e2842 > 0i)))];
let _e2849 = (_e2825 + 1024i);
let _e2851 = select(_e2831, _e2849, (_e2849 < _e2831));
let _e2857 = global_4.member[bitcast<u32>(select(0i, _e2851, (_e2851 > 0i)))];
let _e2858 = (_e2825 + 1028i);
let _e2860 = select(_e2831, _e2858, (_e2858 < _e2831));
let _e2866 = global_4.member[bitcast<u32>(select(0i, _e2860, (_e2860 > 0i)))];
let _e2871 = (bitcast<f32>(((_e2839 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2879 = (_e2871 + (((bitcast<f32>(((_e2848 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2871) * _e2829));
let _e2884 = (bitcast<f32>(((_e2857 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2895 = (_e2879 + (((_e2884 + (((bitcast<f32>(((_e2866 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2884) * _e2829)) - _e2879) * (_e2790 - f32(_e2807))));
let _e2899 = -((_e2895 * (_e2787 * _e2672.member)));
let _e2901 = select(-87f, _e2899, (_e2899 > -87f));
let _e2903 = select(88f, _e2901, (_e2901 < 88f));
let _e2905 = ((_e2903 * 1.442695f) + 0.5f);
let _e2907 = select(-127f, _e2905, (_e2905 > -127f));
let _e2909 = select(128f, _e2907, (_e2907 < 128f));
let _e2916 = select(0i, select(select(i32(_e2909), i32(-2147483648), (_e2909 < -2147483600f)), 2147483647i, (_e2909 > 2147483500f)), (_e2909 == _e2909));
let _e2920 = (_e2916 - select(0i, 1i, (_e2909 < f32(_e2916))));
let _e2921 = f32(_e2920);
let _e2925 = ((_e2903 - (_e2921 * 0.6933594f)) - (_e2921 * -2.1219444e-4f));
let _e2945 = ((1f + (_e2925 * (1f + (_e2925 * (0.5f + (_e2925 * (0.16666667f + (_e2925 * (0.041666668f + (_e2925 * (0.008333334f + (_e2925 * (0.001388889f + (_e2925 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2920 + 127i)) << bitcast<u32>(23i))));
let _e2946 = (1f - _e2945);
phi_5779_ = type_31(_e2945, _e2946, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e2946 / select(1e-12f, _e2895, (_e2895 > 1e-12f))))));
} else {
let _e2954 = (_e2464 * 255f);
let _e2955 = (_e2188.member * 255f);
let _e2956 = (255f - 1f);
let _e2958 = select(0f, _e2954, (_e2954 > 0f));
let _e2960 = select(_e2956, _e2958, (_e2958 < _e2956));
let _e2967 = select(0i, select(select(i32(_e2960), i32(-2147483648), (_e2960 < -2147483600f)), 2147483647i, (_e2960 > 2147483500f)), (_e2960 == _e2960));
let _e2971 = (_e2967 - select(0i, 1i, (_e2960 < f32(_e2967))));
let _e2973 = select(0f, _e2955, (_e2955 > 0f));
let _e2975 = select(_e2956, _e2973, (_e2973 < _e2956));
let _e2982 = select(0i, select(select(i32(_e2975), i32(-2147483648), (_e2975 < -2147483600f)), 2147483647i, (_e2975 > 2147483500f)), (_e2975 == _e2975));
let _e2986 = (_e2982 - select(0i, 1i, (_e2975 < f32(_e2982))));
let _e2989 = (((_e2971 * 256i) + _e2986) * 4i);
let _e2991 = (_e2954 - f32(_e2971));
let _e2993 = (_e2955 - f32(_e2986));
let _e2995 = (bitcast<i32>(_e90) - 1i);
let _e2997 = select(_e2995, _e2989, (_e2989 < _e2995));
let _e3003 = global_4.member[bitcast<u32>(select(0i, _e2997, (_e2997 > 0i)))];
let _e3004 = (_e2989 + 4i);
let _e3006 = select(_e2995, _e3004, (_e3004 < _e2995));
let _e3012 = global_4.member[bitcast<u32>(select(0i, _e3006, (_e3006 > 0i)))];
let _e3013 = (_e2989 + 1024i);
let _e3015 = select(_e2995, _e3013, (_e3013 < _e2995));
let _e3021 = global_4.member[bitcast<u32>(select(0i, _e3015, (_e3015 > 0i)))];
let _e3022 = (_e2989 + 1028i);
let _e3024 = select(_e2995, _e3022, (_e3022 < _e2995));
let _e3030 = global_4.member[bitcast<u32>(select(0i, _e3024, (_e3024 > 0i)))];
let _e3035 = (bitcast<f32>(((_e3003 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3043 = (_e3035 + (((bitcast<f32>(((_e3012 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3035) * _e2993));
let _e3048 = (bitcast<f32>(((_e3021 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3059 = (_e3043 + (((_e3048 + (((bitcast<f32>(((_e3030 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3048) * _e2993)) - _e3043) * _e2991));
let _e3072 = (bitcast<f32>((((_e3003 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3080 = (_e3072 + (((bitcast<f32>((((_e3012 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3072) * _e2993));
let _e3085 = (bitcast<f32>((((_e3021 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3097 = (_e2989 + 1i);
let _e3099 = select(_e2995, _e3097, (_e3097 < _e2995));
let _e3105 = global_4.member[bitcast<u32>(select(0i, _e3099, (_e3099 > 0i)))];
let _e3106 = (_e2989 + 5i);
let _e3108 = select(_e2995, _e3106, (_e3106 < _e2995));
let _e3114 = global_4.member[bitcast<u32>(select(0i, _e3108, (_e3108 > 0i)))];
let _e3115 = (_e2989 + 1025i);
let _e3117 = select(_e2995, _e3115, (_e3115 < _e2995));
let _e3123 = global_4.member[bitcast<u32>(select(0i, _e3117, (_e3117 > 0i)))];
let _e3124 = (_e2989 + 1029i);
let _e3126 = select(_e2995, _e3124, (_e3124 < _e2995));
let _e3132 = global_4.member[bitcast<u32>(select(0i, _e3126, (_e3126 > 0i)))];
let _e3137 = (bitcast<f32>(((_e3105 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3145 = (_e3137 + (((bitcast<f32>(((_e3114 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3137) * _e2993));
let _e3150 = (bitcast<f32>(((_e3123 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3174 = (bitcast<f32>((((_e3105 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3182 = (_e3174 + (((bitcast<f32>((((_e3114 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3174) * _e2993));
let _e3187 = (bitcast<f32>((((_e3123 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3202 = (_e2787 * _e2672.member_1);
let _e3204 = -(((_e3080 + (((_e3085 + (((bitcast<f32>((((_e3030 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3085) * _e2993)) - _e3080) * _e2991)) * _e3202));
let _e3206 = select(-87f, _e3204, (_e3204 > -87f));
let _e3208 = select(88f, _e3206, (_e3206 < 88f));
let _e3210 = ((_e3208 * 1.442695f) + 0.5f);
let _e3212 = select(-127f, _e3210, (_e3210 > -127f));
let _e3214 = select(128f, _e3212, (_e3212 < 128f));
let _e3221 = select(0i, select(select(i32(_e3214), i32(-2147483648), (_e3214 < -2147483600f)), 2147483647i, (_e3214 > 2147483500f)), (_e3214 == _e3214));
let _e3225 = (_e3221 - select(0i, 1i, (_e3214 < f32(_e3221))));
let _e3226 = f32(_e3225);
let _e3230 = ((_e3208 - (_e3226 * 0.6933594f)) - (_e3226 * -2.1219444e-4f));
let _e3252 = -(((_e3145 + (((_e3150 + (((bitcast<f32>(((_e3132 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3150) * _e2993)) - _e3145) * _e2991)) * _e3202));
let _e3254 = select(-87f, _e3252, (_e3252 > -87f));
let _e3256 = select(88f, _e3254, (_e3254 < 88f));
let _e3258 = ((_e3256 * 1.442695f) + 0.5f);
let _e3260 = select(-127f, _e3258, (_e3258 > -127f));
let _e3262 = select(128f, _e3260, (_e3260 < 128f));
let _e3269 = select(0i, select(select(i32(_e3262), i32(-2147483648), (_e3262 < -2147483600f)), 2147483647i, (_e3262 > 2147483500f)), (_e3262 == _e3262));
let _e3273 = (_e3269 - select(0i, 1i, (_e3262 < f32(_e3269))));
let _e3274 = f32(_e3273);
let _e3278 = ((_e3256 - (_e3274 * 0.6933594f)) - (_e3274 * -2.1219444e-4f));
let _e3300 = -(((_e3182 + (((_e3187 + (((bitcast<f32>((((_e3132 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3187) * _e2993)) - _e3182) * _e2991)) * _e3202));
let _e3302 = select(-87f, _e3300, (_e3300 > -87f));
let _e3304 = select(88f, _e3302, (_e3302 < 88f));
let _e3306 = ((_e3304 * 1.442695f) + 0.5f);
let _e3308 = select(-127f, _e3306, (_e3306 > -127f));
let _e3310 = select(128f, _e3308, (_e3308 < 128f));
let _e3317 = select(0i, select(select(i32(_e3310), i32(-2147483648), (_e3310 < -2147483600f)), 2147483647i, (_e3310 > 2147483500f)), (_e3310 == _e3310));
let _e3321 = (_e3317 - select(0i, 1i, (_e3310 < f32(_e3317))));
let _e3322 = f32(_e3321);
let _e3326 = ((_e3304 - (_e3322 * 0.6933594f)) - (_e3322 * -2.1219444e-4f));
let _e3349 = -((_e3059 * (_e2787 * _e2672.member)));
let _e3351 = select(-87f, _e3349, (_e3349 > -87f));
let _e3353 = select(88f, _e3351, (_e3351 < 88f));
let _e3355 = ((_e3353 * 1.442695f) + 0.5f);
let _e3357 = select(-127f, _e3355, (_e3355 > -127f));
let _e3359 = select(128f, _e3357, (_e3357 < 128f));
let _e3366 = select(0i, select(select(i32(_e3359), i32(-2147483648), (_e3359 < -2147483600f)), 2147483647i, (_e3359 > 2147483500f)), (_e3359 == _e3359));
let _e3370 = (_e3366 - select(0i, 1i, (_e3359 < f32(_e3366))));
let _e3371 = f32(_e3370);
let _e3375 = ((_e3353 - (_e3371 * 0.6933594f)) - (_e3371 * -2.1219444e-4f));
let _e3395 = ((1f + (_e3375 * (1f + (_e3375 * (0.5f + (_e3375 * (0.16666667f + (_e3375 * (0.041666668f + (_e3375 * (0.008333334f + (_e3375 * (0.001388889f + (_e3375 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3370 + 127i)) << bitcast<u32>(23i))));
let _e3396 = (1f - _e3395);
phi_5779_ = type_31(_e3395, _e3396, vec3<f32>(((1f + (_e3230 * (1f + (_e3230 * (0.5f + (_e3230 * (0.16666667f + (_e3230 * (0.041666668f + (_e3230 * (0.008333334f + (_e3230 * (0.001388889f + (_e3230 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3225 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3278 * (1f + (_e3278 * (0.5f + (_e3278 * (0.16666667f + (_e3278 * (0.041666668f + (_e3278 * (0.008333334f + (_e3278 * (0.001388889f + (_e3278 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3273 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3326 * (1f + (_e3326 * (0.5f + (_e3326 * (0.16666667f + (_e3326 * (0.041666668f + (_e3326 * (0.008333334f + (_e3326 * (0.001388889f + (_e3326 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3321 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e3396 / select(1e-12f, _e3059, (_e3059 > 1e-12f))))));
}
let _e3404 = phi_5779_;
if _e716 {
let _e3408 = global_1.member.member_5.member_2;
let _e3416 = global_1.member.member_5.member_4;
let _e3419 = (_e2188.member_3.x * _e2672.member_2);
let _e3421 = (_e2188.member_3.y * _e2672.member_2);
let _e3423 = (_e2188.member_3.z * _e2672.member_2);
let _e3424 = (0.5f * (_e3408 / select(1e-6f, _e180, (_e180 > 1e-6f))));
let _e3428 = (_e158 + (_e3419 * _e3424));
let _e3429 = (_e169 + (_e3421 * _e3424));
let _e3430 = (_e180 + (_e3423 * _e3424));
let _e3432 = (2f * _e3408);
let _e3434 = ((_e3430 * _e3430) + (_e3432 * _e3423));
let _e3438 = (_e3430 + sqrt(select(0f, _e3434, (_e3434 > 0f))));
let _e3442 = (0.5f * (_e3432 / select(1e-6f, _e3438, (_e3438 > 1e-6f))));
let _e3446 = (_e3428 + (_e3419 * _e3442));
let _e3447 = (_e3429 + (_e3421 * _e3442));
let _e3448 = (_e3430 + (_e3423 * _e3442));
let _e3452 = (_e3416 * _e3416);
let _e3454 = (_e3448 * _e3448);
let _e3462 = (((_e3430 <= 0f) || (_e3434 <= 0f)) || ((_e3448 <= 0f) || (_e3454 <= (_e3452 * (((_e3446 * _e3446) + (_e3447 * _e3447)) + _e3454)))));
let _e3476 = (_e158 + ((_e2188.member_4.x * _e2672.member_2) * _e3408));
let _e3477 = (_e169 + ((_e2188.member_4.y * _e2672.member_2) * _e3408));
let _e3478 = (_e180 + ((_e2188.member_4.z * _e2672.member_2) * _e3408));
let _e3480 = (_e3478 * _e3478);
let _e3489 = ((_e2467 & 1u) != 0u);
let _e3493 = select(_e3462, ((_e3478 <= 0f) || (_e3480 <= (_e3452 * (((_e3476 * _e3476) + (_e3477 * _e3477)) + _e3480)))), _e3489);
phi_5930_ = select(select(select(_e3448, _e3430, _e3462), _e3478, _e3489), _e180, _e3493);
phi_5931_ = select(select(select(_e3447, _e3429, _e3462), _e3477, _e3489), _e169, _e3493);
phi_5932_ = select(select(select(_e3446, _e3428, _e3462), _e3476, _e3489), _e158, _e3493);
phi_5933_ = select(1f, 0f, _e3493);
} else {
phi_5930_ = _e180;
phi_5931_ = _e169;
phi_5932_ = _e158;
phi_5933_ = 1f;
}
let _e3499 = phi_5930_;
let _e3501 = phi_5931_;
let _e3503 = phi_5932_;
let _e3505 = phi_5933_;
let _e3508 = (_e3404.member * _e3505);
global_5.member[_e115] = (_e126 * (_e3404.member_2.x * _e3508));
global_5.member[_e127] = (_e136 * (_e3404.member_2.y * _e3508));
global_5.member[_e138] = (_e147 * (_e3404.member_2.z * _e3508));
global_5.member[_e149] = _e3503;
global_5.member[_e160] = _e3501;
global_5.member[_e171] = _e3499;
global_5.member[_e182] = _e191;
global_5.member[_e193] = _e202;
global_5.member[_e204] = _e213;
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
